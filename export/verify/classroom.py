"""The template repository for students: its workflow's own commands judge what they would push."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

from export.package import ExportError
from export.verify.workflow import run_job
from judge.kit.paths import REFERENCE

WORKFLOW = Path(".github/workflows/judge.yml")
JOB = "judge"
REPORTS = ("report.html", "report.json", "report.txt", "junit.xml")
STARTERS = ("solution.py", "solution.cpp", "Solution.java")


def verify(package: Path, scratch: Path) -> list[str]:
    """Push nothing, each starter, and the reference. Raises ExportError; returns what was done."""
    repository = scratch / "repository"
    shutil.copytree(package, repository)
    _git(repository, "init", "--quiet")
    told = pushed(repository, {}, "", "found 0")
    for starter in STARTERS:
        source = repository / "starters" / starter
        told += pushed(repository, {starter: source}, "WA  0 of 100 points", "misses")
    told += pushed(repository, {"solution.py": REFERENCE}, "AC  100 of 100 points", "large")
    check_ignored(repository, package)
    return told


def pushed(repository: Path, files: dict[str, Path], verdict: str, said: str) -> list[str]:
    """Run the workflow with these files at the top of the repository.

    verdict: how the summary's title begins; empty: there is nothing to judge. said: words of the
    summary. Raises ExportError unless all is as expected.
    """
    shutil.rmtree(repository / "reports", ignore_errors=True)
    for path in repository.glob("[sS]olution.*"):
        path.unlink()
    for name, source in files.items():
        shutil.copyfile(source, repository / name)
    what = ", ".join(files) or "nothing"
    ran = run_job(repository / WORKFLOW, JOB, repository)
    if bool(ran.failed) == verdict.startswith("AC"):
        raise ExportError(f"{what}: unexpected end of the workflow: {'; '.join(ran.told)}")
    title = f"## {verdict}" if verdict else "Expected one file solution.*"
    if not ran.summary.startswith(title) or said not in ran.summary:
        raise ExportError(f"{what}: expected {title!r} and {said!r}, found {ran.summary!r}")
    missing = [
        name for name in REPORTS if verdict and not (repository / "reports" / name).is_file()
    ]
    if missing:
        raise ExportError(f"{what}: expected the report {missing[0]}, found none")
    return [f"{what}: {verdict or 'no program'}", *(f"  {line}" for line in ran.told)]


def check_ignored(repository: Path, package: Path) -> None:
    """Raise ExportError unless git sees the files of the package, and none that a judging made."""
    for path in repository.glob("[sS]olution.*"):
        path.unlink()
    seen = set(_git(repository, "ls-files", "--others", "--exclude-standard").splitlines())
    known = {path.relative_to(package).as_posix() for path in package.rglob("*") if path.is_file()}
    for name in sorted(seen ^ known):
        raise ExportError(f"git would {'commit' if name in seen else 'ignore'} {name}")


def _git(repository: Path, *arguments: str) -> str:
    command = ["git", "-C", str(repository), *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise ExportError(f"{' '.join(command)}: {done.stderr.strip()}")
    return done.stdout
