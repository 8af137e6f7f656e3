"""Runs a GitHub workflow's own commands, step by step, as a runner does.

Steps that use an action are skipped, and steps that would change this machine: see `skipped`.
"""

from __future__ import annotations

import os
import subprocess
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import yaml

from export.verify.job import VerifyError

SHELL = ("bash", "--noprofile", "--norc", "-eo", "pipefail", "-c")  # GitHub's `shell: bash`
STEP_S = 900.0
CHANGES = ("sudo ", "apt-get ", "git config --global")


@dataclass(frozen=True, slots=True)
class Ran:
    """A job that was run. failed: the name of the first failed step, empty for none.

    summary: what the steps wrote for the summary of the run. told: a line for each step.
    """

    failed: str
    summary: str
    told: tuple[str, ...]


def steps_of(workflow: Path, job: str) -> list[dict[str, Any]]:
    """Return the steps of a job. Raises VerifyError."""
    try:
        steps = yaml.safe_load(workflow.read_text(encoding="utf-8"))["jobs"][job]["steps"]
    except (OSError, yaml.YAMLError, KeyError, TypeError) as error:
        raise VerifyError(f"{workflow}: expected steps of the job {job!r}: {error}") from None
    found: list[dict[str, Any]] = steps
    return found


def skipped(step: Mapping[str, Any]) -> str:
    """Return why a step cannot be run here, empty if it can."""
    if "uses" in step:
        return f"it uses {step['uses']}"
    change = next((word for word in CHANGES if word in step["run"]), None)
    return "" if change is None else f"{change.strip()!r} would change this machine"


def run_job(workflow: Path, job: str, directory: Path) -> Ran:
    """Run a job's commands in a directory. Raises VerifyError if a step does not end."""
    summary = directory.parent / "summary.md"
    summary.unlink(missing_ok=True)
    told, failed = [], ""
    for name, step in _named(steps_of(workflow, job)):
        if why := skipped(step):
            told.append(f"{name}: skipped: {why}")
        elif not failed or step.get("if") == "always()":
            began = time.monotonic()
            status = _run(step, directory, summary)
            failed = failed or (name if status else "")
            told.append(f"{name}: exit status {status}, {time.monotonic() - began:.0f} s")
    text = summary.read_text(encoding="utf-8") if summary.is_file() else ""
    return Ran(failed, text, tuple(told))


def _named(steps: list[dict[str, Any]]) -> Iterator[tuple[str, dict[str, Any]]]:
    for number, step in enumerate(steps, 1):
        yield step.get("name", f"step {number}"), step


def _run(step: Mapping[str, Any], directory: Path, summary: Path) -> int:
    """Run the commands of a step and return the exit status."""
    environment = {**os.environ, "GITHUB_STEP_SUMMARY": str(summary), "CI": "true"}
    try:
        return subprocess.run(
            [*SHELL, step["run"]],
            cwd=directory,
            env=environment,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            timeout=STEP_S,
            check=False,
        ).returncode
    except subprocess.TimeoutExpired:
        raise VerifyError(f"{step.get('name')}: not done within {STEP_S:.0f} s") from None
