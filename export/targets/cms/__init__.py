"""CMS, the Contest Management System: a task in its Italian format, for `cmsImportTask`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from export.files import Files
from export.formats.layout import LANGUAGE, runnable
from export.formats.yaml import as_yaml
from export.package import Package
from export.statement.pdf import statement_pdf
from export.target import Target

# A script needs no compiler, and no build for the processor of the workers. It runs wherever
# submissions in Python do. Without a checker, CMS would compare letter case.
CHECKER = Path(__file__).parent / "checker.py"
INPUT, ANSWER = "input/input{}.txt", "output/output{}.txt"  # numbered from 0


def build(package: Package) -> Files:
    """Lay out the task in a directory of its name."""
    files = Files()
    files.add("task.yaml", as_yaml(task(package)))
    files.add("gen/GEN", subtasks(package))
    parts = package.statement.sections
    pdf = statement_pdf(package.statement, parts, package.samples)
    files.add("statement/statement.pdf", pdf)
    files.add("check/checker", CHECKER, executable=True)
    cases = [case for group in package.groups for case in group.cases]
    for number, case in enumerate(cases):
        files.add(INPUT.format(number), case.input)
        files.add(ANSWER.format(number), case.answer)
    for submission in runnable(package):
        files.add(f"sol/{submission.name}", submission.path)
    below = Files()
    below.merge(files, f"{package.problem.short_name}/")
    return below


def task(package: Package) -> dict[str, Any]:
    """Return task.yaml. An empty file name stands for a standard stream."""
    problem = package.problem
    return {
        "name": problem.short_name,
        "title": problem.name,
        "primary_language": LANGUAGE,
        "time_limit": problem.limits.time_limit_s,
        "memory_limit": problem.limits.memory_mib,
        "infile": "",
        "outfile": "",
        "n_input": sum(len(group.cases) for group in package.groups),
        "public_testcases": ",".join(map(str, range(len(package.samples)))),
        "token_mode": "disabled",
        "score_mode": "max",
        "feedback_level": "full" if problem.feedback.name_secret_cases else "restricted",
    }


def subtasks(package: Package) -> str:
    """Return gen/GEN: a subtask for each group with its points, and its cases line by line.

    CMS makes it a score of type GroupMin: the points of a group need all of its cases.
    """
    lines = []
    for group in package.groups:
        lines.append(f"#ST: {group.declared.points}")
        lines += [case.name for case in group.cases]
    return "\n".join(lines) + "\n"


TARGETS = (
    Target(
        name="cms",
        title="CMS (Contest Management System), points by group",
        build=build,
        import_it="Unpack it, then: cmsImportTask --loader italy_yaml DIRECTORY",
    ),
)
