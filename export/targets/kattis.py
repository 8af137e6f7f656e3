"""Kattis, the legacy format: scoring with points by group, or pass-fail. `verifyproblem` reads it.

Source: Kattis problem package format, version legacy.
"""

from __future__ import annotations

from functools import partial
from typing import Any

from export.files import Files
from export.formats import layout
from export.formats.validators import GROUP_OPTION, input_validator
from export.formats.yaml import as_yaml
from export.package import ACCEPTED, Package, Submission
from export.target import Target

VALIDATOR = "validate_input"


def build(package: Package, target: str, *, points: bool) -> Files:
    """Lay out the package below `collisioncourse/`. points: scoring, else pass-fail."""
    inner = Files()
    inner.add("problem.yaml", as_yaml(_metadata(package, target, points=points)))
    layout.add_statement(inner, package, "problem_statement", points=points)
    layout.add_cases(inner, package)
    _add_groups(inner, package, points=points)
    inner.merge(input_validator(package), f"input_validators/{VALIDATOR}/")
    for submission in layout.runnable(package):
        folder = _folder(package, submission, points=points)
        if folder is not None:
            inner.add(f"submissions/{folder}/{submission.file}", submission.path)
    files = Files()
    files.merge(inner, f"{package.problem.short_name}/")
    return files


def _metadata(package: Package, target: str, *, points: bool) -> dict[str, Any]:
    problem, limits = package.problem, package.problem.limits
    table: dict[str, Any] = {
        "problem_format_version": "legacy",
        "uuid": layout.own_uuid(package, target),
        "name": problem.name,
        "type": "scoring" if points else "pass-fail",
        "author": problem.rights_owner,
        "license": layout.license_word(package),
        "rights_owner": problem.rights_owner,
        "validation": "default",
        "limits": {
            "memory": limits.memory_mib,
            "output": limits.output_mib,
            "code": limits.code_kib,
            "compilation_time": int(limits.compilation_time_s),
            "compilation_memory": limits.compilation_memory_mib,
            # The time limit follows from the slowest accepted submission, on every machine.
            "time_multiplier": limits.time_multipliers.ac_to_time_limit,
            "time_safety_margin": limits.time_multipliers.time_limit_to_tle,
        },
    }
    if points:
        table["grading"] = {"objective": "max", "show_test_data_groups": True}
    return table


def _add_groups(files: Files, package: Package, *, points: bool) -> None:
    """Add testdata.yaml for each group: its promises, and its points, all or nothing."""
    if points:
        whole = {
            "on_reject": "continue",
            "range": f"0 {package.problem.max_score}",
            "grader_flags": "accept_if_any_accepted",
        }
        files.add("data/secret/testdata.yaml", as_yaml(whole))
        ignoring = {**whole, "grader_flags": "ignore_sample accept_if_any_accepted"}
        files.add("data/testdata.yaml", as_yaml(ignoring))
    for group in package.groups:
        table: dict[str, Any] = {"input_validator_flags": f"{GROUP_OPTION} {group.name}"}
        if points:
            score = group.declared.points
            table |= {
                "on_reject": "break",
                "grader_flags": "min",
                "accept_score": score,
                "range": f"0 {score}",
            }
        directory = layout.group_directory(package, group)
        files.add(f"data/{directory}/testdata.yaml", as_yaml(table))


def _folder(package: Package, submission: Submission, *, points: bool) -> str | None:
    """Return the folder for a submission; None if the format has none for its verdicts.

    The format knows one verdict for each submission, the first that is not AC.
    """
    if points and submission.overall != ACCEPTED and package.points(submission):
        return "partially_accepted"
    return layout.folder(submission)


TARGETS = (
    Target(
        name="kattis",
        title="Kattis (legacy format), points by group",
        build=partial(build, target="kattis", points=True),
        import_it="Unpack it, run 'verifyproblem collisioncourse', and upload the zip to Kattis.",
    ),
    Target(
        name="kattis-pass-fail",
        title="Kattis (legacy format), pass-fail",
        build=partial(build, target="kattis-pass-fail", points=False),
        import_it="Unpack it, run 'verifyproblem collisioncourse', and upload the zip to Kattis.",
    ),
)
