"""The CPU time of one run of a program."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Sequence
from pathlib import Path

from judge.kit.errors import KitError


class BenchError(KitError):
    """A program that is measured failed."""


def cpu_s(command: Sequence[str], file: Path) -> float:
    """Run a command with the file as its input; return its CPU seconds. Raises BenchError."""
    with file.open("rb") as stdin:
        process = subprocess.Popen(command, stdin=stdin, stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise BenchError(f"{command[-1]}: exit status {process.returncode} on {file}")
    return usage.ru_utime + usage.ru_stime
