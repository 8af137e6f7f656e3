"""Kattis problem package format 2025-09: pass-fail for BAPCtools, scoring for judges that can.

Source: Kattis problem package format, version 2025-09.
"""

from __future__ import annotations

from functools import partial
from typing import Any

from export.files import Files
from export.formats import layout
from export.formats.described import describe
from export.formats.validators import GROUP_OPTION, answer_validator, input_validator
from export.formats.yaml import as_yaml
from export.package import ACCEPTED, Package, Submission
from export.target import Target
from judge.problem.verdict import Verdict

VERSION = "2025-09"
VALIDATOR, ANSWER_VALIDATOR = "validate_input", "validate_answer"


def build(package: Package, target: str, *, points: bool) -> Files:
    """Lay out the package below `collisioncourse/`. points: scoring, else pass-fail."""
    inner = Files()
    inner.add("problem.yaml", as_yaml(_metadata(package, target, points=points)))
    layout.add_statement(inner, package, "statement", points=points)
    layout.add_cases(inner, package)
    _add_groups(inner, package, points=points)
    _add_descriptions(inner, package)
    _add_invalid_inputs(inner, package)
    inner.merge(input_validator(package), f"input_validators/{VALIDATOR}/")
    inner.merge(answer_validator(), f"answer_validators/{ANSWER_VALIDATOR}/")
    for submission in layout.runnable(package):
        inner.add(f"submissions/{_folder(submission)}/{submission.file}", submission.path)
    inner.add("submissions/submissions.yaml", as_yaml(_expectations(package)))
    files = Files()
    files.merge(inner, f"{package.problem.short_name}/")
    return files


def _metadata(package: Package, target: str, *, points: bool) -> dict[str, Any]:
    problem, limits = package.problem, package.problem.limits
    return {
        "problem_format_version": VERSION,
        "type": "scoring" if points else "pass-fail",
        "name": {layout.LANGUAGE: problem.name},
        "uuid": layout.own_uuid(package, target),
        "license": layout.license_word(package),
        "rights_owner": problem.rights_owner,
        "limits": {
            "time_limit": limits.time_limit_s,
            "time_multipliers": {
                "ac_to_time_limit": limits.time_multipliers.ac_to_time_limit,
                "time_limit_to_tle": limits.time_multipliers.time_limit_to_tle,
            },
            "memory": limits.memory_mib,
            "output": limits.output_mib,
            "code": limits.code_kib,
            "compilation_time": int(limits.compilation_time_s),
            "compilation_memory": limits.compilation_memory_mib,
        },
    }


def _add_groups(files: Files, package: Package, *, points: bool) -> None:
    """Add test_group.yaml for each group: its promises, and its points, all or nothing."""
    if points:
        whole = {"max_score": package.problem.max_score, "score_aggregation": "sum"}
        files.add("data/secret/test_group.yaml", as_yaml(whole))
    for group in package.groups:
        table: dict[str, Any] = {"input_validator_args": [GROUP_OPTION, group.name]}
        if points and group.name != "sample":
            table |= {"max_score": group.declared.points, "score_aggregation": "pass-fail"}
        directory = layout.group_directory(package, group)
        files.add(f"data/{directory}/test_group.yaml", as_yaml(table))


def _add_descriptions(files: Files, package: Package) -> None:
    """Add what each secret case is for, and a hint."""
    for group in package.secret:
        directory = layout.group_directory(package, group)
        for case in group.cases:
            described = describe(package, case)
            table = {"description": described.text, "hint": described.hint}
            table = {key: text for key, text in table.items() if text}
            if table:
                files.add(f"data/{directory}/{case.input.stem}.yaml", as_yaml(table))


def _add_invalid_inputs(files: Files, package: Package) -> None:
    """Add the inputs that the validator must reject; those of a group have its arguments."""
    for invalid in package.invalid_inputs:
        files.add(f"data/invalid_input/{invalid.name}.in", invalid.path)
        if invalid.group:
            table = {"input_validator_args": [GROUP_OPTION, invalid.group]}
            files.add(f"data/invalid_input/{invalid.name}.yaml", as_yaml(table))


def _folder(submission: Submission) -> str:
    """Return the folder: the format has one for verdicts that are not certain, too."""
    return layout.folder(submission) or "rejected"


def _expectations(package: Package) -> dict[str, Any]:
    """Return what each submission may and must get, group by group.

    Only slow submissions and accepted ones set the time limit: how long a wrong one takes does
    not matter.
    """
    table: dict[str, Any] = {}
    for submission in layout.runnable(package):
        if submission.overall == ACCEPTED:
            continue
        verdicts = layout.coarse(submission.overall)
        entry: dict[str, Any] = {
            "permitted": layout.in_order({*verdicts, Verdict.AC}),
            "required": layout.in_order(verdicts),
        }
        if verdicts != {Verdict.TLE}:
            entry["use_for_time_limit"] = False
        for group in package.groups:
            if submission.expected[group.name] == ACCEPTED:
                glob = layout.group_directory(package, group)
                entry[glob] = {"permitted": ["AC"], "use_for_time_limit": False}
        table[f"{_folder(submission)}/{submission.file}"] = entry
    return table


TARGETS = (
    Target(
        name="bapctools",
        title="BAPCtools (Kattis format 2025-09), pass-fail",
        build=partial(build, target="bapctools", points=False),
        import_it="Unpack it, then run 'bt validate' and 'bt run' in it.",
    ),
    Target(
        name="kattis-2025",
        title="judges of the Kattis format 2025-09 with scoring, points by group",
        build=partial(build, target="kattis-2025", points=True),
        import_it="Upload the zip to a judge that reads format 2025-09 with scoring.",
    ),
)
