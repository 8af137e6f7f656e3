"""DOMjudge: the zip that its import page takes. Pass-fail, without a top folder.

Source: DOMjudge manual, problem format; laid out as BAPCtools' legacy zip is.
"""

from __future__ import annotations

from export.files import Files
from export.formats import layout
from export.formats.described import describe
from export.formats.yaml import as_yaml
from export.package import Package, Submission
from export.statement.pdf import statement_pdf
from export.statement.read import GROUPS
from export.target import Target
from judge.problem.verdict import Verdict

# DOMjudge compares a submission's verdict with the word after this mark in its source.
MARK = "@EXPECTED_RESULTS@"
RESULTS = {
    Verdict.AC: "ACCEPTED",
    Verdict.WA: "WRONG_ANSWER",
    Verdict.TLE: "TIME_LIMIT_EXCEEDED",
    Verdict.RTE: "RUN_TIME_ERROR",
    Verdict.CE: "COMPILER_ERROR",
}
COMMENTS = {".py": "#", ".cpp": "//", ".java": "//"}


def build(package: Package) -> Files:
    """Lay out the package."""
    problem, limits = package.problem, package.problem.limits
    files = Files()
    metadata = {
        "name": problem.name,
        "license": layout.license_word(package),
        "rights_owner": problem.rights_owner,
        "validation": "default",
        "limits": {
            "time_limit": limits.time_limit_s,
            "memory": limits.memory_mib,
            "output": limits.output_mib,
        },
    }
    files.add("problem.yaml", as_yaml(metadata))
    files.add(".timelimit", f"{limits.time_limit_s:g}\n")
    # Without this file, the problem is named after the zip.
    names = f"externalid = {problem.short_name}\nshort-name = {problem.short_name}\n"
    files.add("domjudge-problem.ini", names)
    parts = package.statement.without(GROUPS)
    files.add("problem.pdf", statement_pdf(package.statement, parts, package.samples))
    _add_cases(files, package)
    for submission in package.submissions:
        _add_submission(files, submission)
    return files


def _add_cases(files: Files, package: Package) -> None:
    """Add the cases; secret ones in one directory, as all versions of DOMjudge find them there."""
    for case, note in zip(package.samples, package.statement.notes, strict=True):
        files.add(f"data/sample/{case.input.name}", case.input)
        files.add(f"data/sample/{case.answer.name}", case.answer)
        files.add(f"data/sample/{case.input.stem}.svg", note.figure)
        files.add(f"data/sample/{case.input.stem}.desc", f"{note.title}\n")
    for number, group in enumerate(package.secret, 1):
        for case in group.cases:
            stem = f"data/secret/{number}-{group.name}-{case.input.stem}"
            files.add(f"{stem}.in", case.input)
            files.add(f"{stem}.ans", case.answer)
            files.add(f"{stem}.desc", f"{describe(package, case).text}\n")


def _add_submission(files: Files, submission: Submission) -> None:
    """Add a submission with its expected verdict, if that is certain.

    DOMjudge names a folder after one verdict, and reports a conflict if the mark names two.
    """
    verdicts = layout.coarse(submission.overall)
    if len(verdicts) != 1:
        return
    result = RESULTS[next(iter(verdicts))]
    source = submission.path.read_text(encoding="utf-8").rstrip("\n")
    mark = f"{COMMENTS[submission.path.suffix]} {MARK}: {result}"
    files.add(f"submissions/{result.lower()}/{submission.file}", f"{source}\n\n{mark}\n")


TARGETS = (
    Target(
        name="domjudge",
        title="DOMjudge, pass-fail",
        build=build,
        import_it="Upload it in DOMjudge under Jury > Import / export > Problem archive.",
    ),
)
