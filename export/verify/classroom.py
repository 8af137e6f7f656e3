"""The template repository for students: its workflow's own commands judge what they would push."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

from export.verify.job import Job, VerifyError
from export.verify.workflow import run_job
from judge.kit.paths import REFERENCE

WORKFLOW = Path(".github/workflows/judge.yml")
JOB = "judge"
REPORTS = ("report.html", "report.json", "report.txt", "junit.xml")
STARTERS = ("solution.py", "solution.cpp", "Solution.java")


def verify(job: Job) -> list[str]:
    """Push nothing, the starters, the reference. quick: one starter only. Raises VerifyError."""
    repository = job.scratch / "repository"
    shutil.copytree(job.package, repository)
    _git(repository, "init", "--quiet")
    told = pushed(repository, {}, "", "found 0")
    for starter in STARTERS[:1] if job.quick else STARTERS:
        source = repository / "starters" / starter
        told += pushed(repository, {starter: source}, "WA  0 of 100 points", "misses")
    if not job.quick:
        told += pushed(repository, {"solution.py": REFERENCE}, "AC  100 of 100 points", "many")
    check_ignored(repository, job.package)
    return told


def pushed(repository: Path, files: dict[str, Path], verdict: str, said: str) -> list[str]:
    """Run the workflow with these files at the top of the repository.

    verdict: how the summary's title begins; empty: there is nothing to judge. said: words of the
    summary. Raises VerifyError unless all is as expected.
    """
    shutil.rmtree(repository / "reports", ignore_errors=True)
    for path in repository.glob("[sS]olution.*"):
        path.unlink()
    for name, source in files.items():
        shutil.copyfile(source, repository / name)
    what = ", ".join(files) or "nothing"
    ran = run_job(repository / WORKFLOW, JOB, repository)
    if bool(ran.failed) == verdict.startswith("AC"):
        raise VerifyError(f"{what}: unexpected end of the workflow: {'; '.join(ran.told)}")
    title = f"## {verdict}" if verdict else "Expected one file solution.*"
    if not ran.summary.startswith(title) or said not in ran.summary:
        raise VerifyError(f"{what}: expected {title!r} and {said!r}, found {ran.summary!r}")
    reports = {path.name for path in (repository / "reports").iterdir()}
    missing = sorted(set(REPORTS) - reports) if verdict else []
    if missing:
        raise VerifyError(f"{what}: expected the report {missing[0]}, found none")
    return [f"{what}: {verdict or 'no program'}", *(f"  {line}" for line in ran.told)]


def check_ignored(repository: Path, package: Path) -> None:
    """Raise VerifyError unless git sees the files of the package, and none that a judging made."""
    for path in repository.glob("[sS]olution.*"):
        path.unlink()
    seen = set(_git(repository, "ls-files", "--others", "--exclude-standard").splitlines())
    known = {path.relative_to(package).as_posix() for path in package.rglob("*") if path.is_file()}
    for name in sorted(seen ^ known):
        raise VerifyError(f"git would {'commit' if name in seen else 'ignore'} {name}")


def _git(repository: Path, *arguments: str) -> str:
    command = ["git", "-C", str(repository), *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        raise VerifyError(f"{' '.join(command)}: {done.stderr.strip()}")
    return done.stdout
