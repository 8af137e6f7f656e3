"""Where the Kattis formats keep the parts of a problem: shared by every target that uses them."""

from __future__ import annotations

from collections.abc import Collection
from uuid import UUID, uuid5

from export.files import Files
from export.package import Package, Submission, TestGroup
from export.statement import latex
from export.statement.figures import figure_pdf
from export.statement.read import GROUPS
from judge.problem.verdict import Verdict

LANGUAGE = "en"
# The format's names of licenses; its versions are not told apart.
LICENSES = {"CC BY-SA 4.0": "cc by-sa"}
# The format's folder of submissions for each verdict that it knows.
FOLDERS = {
    Verdict.AC: "accepted",
    Verdict.WA: "wrong_answer",
    Verdict.TLE: "time_limit_exceeded",
    Verdict.RTE: "run_time_error",
}
# What judges with four verdicts say for the others.
COARSE = {Verdict.MLE: Verdict.RTE, Verdict.OLE: Verdict.RTE}


def own_uuid(package: Package, target: str) -> str:
    """Return a UUID for one target: two packages of one problem must differ."""
    return str(uuid5(UUID(package.problem.uuid), target))


def license_word(package: Package) -> str:
    """Return the license as the format spells it. Raises KeyError for an unknown one."""
    return LICENSES[package.problem.license]


def group_directory(package: Package, group: TestGroup) -> str:
    """Return the directory of a group below data/: `secret/3-large`, in the order of points."""
    if group.name == "sample":
        return "sample"
    return f"secret/{package.secret.index(group) + 1}-{group.name}"


def add_cases(files: Files, package: Package) -> None:
    """Add every test case below data/."""
    for group in package.groups:
        directory = f"data/{group_directory(package, group)}"
        for case in group.cases:
            files.add(f"{directory}/{case.input.name}", case.input)
            files.add(f"{directory}/{case.answer.name}", case.answer)


def add_statement(files: Files, package: Package, directory: str, *, points: bool) -> None:
    """Add the statement in LaTeX with its figures. points: say what the groups score."""
    statement = package.statement
    parts = statement.sections if points else statement.without(GROUPS)
    head = f"\\problemname{{{latex.escape(statement.title)}}}\n\n"
    text = head + latex.sections(parts) + "\n" + latex.notes(statement, "{}.pdf")
    files.add(f"{directory}/problem.{LANGUAGE}.tex", text)
    for note in statement.notes:
        files.add(f"{directory}/{note.figure.stem}.pdf", figure_pdf(note.figure))


def coarse(verdicts: frozenset[Verdict]) -> frozenset[Verdict]:
    """Return verdicts as a judge with AC, WA, TLE and RTE says them."""
    return frozenset(COARSE.get(verdict, verdict) for verdict in verdicts)


def runnable(package: Package) -> tuple[Submission, ...]:
    """Return the submissions that compile: the formats expect no compile errors."""
    return tuple(each for each in package.submissions if each.overall != {Verdict.CE})


def folder(submission: Submission) -> str | None:
    """Return the folder for a submission; None if several verdicts are permitted."""
    verdicts = coarse(submission.overall)
    return FOLDERS[next(iter(verdicts))] if len(verdicts) == 1 else None


def in_order(verdicts: Collection[Verdict]) -> list[str]:
    """Return verdicts as words, in the order of their definition."""
    return [verdict.value for verdict in Verdict if verdict in verdicts]
