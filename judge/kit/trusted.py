"""Runs the kit's own programs on an input, without a sandbox, and reads their answers."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from judge.kit.errors import KitError

TIMEOUT_S = 600.0
ANSWERS = frozenset({"YES", "NO"})


class ProgramError(KitError):
    """A program of the kit failed, or did not write one answer per scenario."""


def python_command(program: Path) -> tuple[str, ...]:
    """Return the command that runs a Python program with the kit's own Python."""
    return (sys.executable, str(program))


def run_trusted(
    name: str, command: Sequence[str], content: bytes = b"", timeout_s: float = TIMEOUT_S
) -> bytes:
    """Run a program on an input and return its standard output.

    name: its name in messages. Raises ProgramError unless it ends with status 0 in time.
    """
    run = run_to_end(name, command, content, timeout_s)
    if run.returncode:
        last = run.stderr.decode(errors="replace").strip().rpartition("\n")[2]
        raise ProgramError(f"{name}: exit status {run.returncode}: {last}".removesuffix(": "))
    return run.stdout


def run_to_end(
    name: str, command: Sequence[str], content: bytes = b"", timeout_s: float = TIMEOUT_S
) -> subprocess.CompletedProcess[bytes]:
    """Run a program on an input and return how it ended. Raises ProgramError if it does not."""
    try:
        return subprocess.run(
            command, input=content, capture_output=True, timeout=timeout_s, check=False
        )
    except subprocess.TimeoutExpired:
        raise ProgramError(f"{name}: no answer within {timeout_s:.0f} s") from None
    except OSError as error:
        raise ProgramError(f"{name}: cannot be run: {error.strerror}") from None


def read_answers(name: str, output: bytes, scenarios: int) -> list[str]:
    """Return the answers in an output, one per scenario. Raises ProgramError for anything else."""
    answers = output.decode(errors="replace").split()
    if len(answers) != scenarios:
        raise ProgramError(f"{name}: expected {scenarios} answers, found {len(answers)}")
    strange = next((answer for answer in answers if answer not in ANSWERS), None)
    if strange is not None:
        raise ProgramError(f"{name}: expected YES or NO, found {strange[:20]!r}")
    return answers
