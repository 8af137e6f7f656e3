"""How much longer a solution takes than reading its input: `python -m bench [GLOB ...]`.

Seconds differ from machine to machine and from minute to minute; the ratio to reading the
same file in the same run hardly does. Each file is read by a bare
`list(map(int, sys.stdin.buffer.read().split()))` and then solved. The ratio of the CPU
seconds is taken for each such pair of runs, and the median ratio is printed.
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from judge.kit.command import run, whole_number
from judge.kit.errors import KitError
from judge.kit.paths import REFERENCE
from judge.kit.store import Store
from judge.kit.trusted import python_command
from judge.problem.data import load_data
from judge.problem.declaration import load

READER = (sys.executable, "-c", "import sys; list(map(int, sys.stdin.buffer.read().split()))")
MEASURED = 0


class BenchError(KitError):
    """A program that is measured failed."""


def main(arguments: Sequence[str]) -> int:
    """Run the command line; return the exit status: 0 measured, 2 nothing to measure."""
    return run("bench", lambda: _measure(_options(arguments)))


def _options(arguments: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m bench",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "globs",
        nargs="*",
        default=["secret/large/*", "secret/many/*"],
        metavar="GLOB",
        help="cases below data/ (default: secret/large/* and secret/many/*)",
    )
    parser.add_argument("--runs", type=whole_number(1), default=5, help="pairs of runs (default 5)")
    parser.add_argument(
        "--program",
        type=Path,
        default=REFERENCE,
        help="a Python program or an executable (default: solution.py)",
    )
    return parser.parse_args(arguments)


def _measure(options: argparse.Namespace) -> int:
    """Print a line for each case. Raises BenchError, CasesError."""
    with Store() as store:
        cases = load_data(load(), globs=options.globs, store=store).chosen
    program: Path = options.program
    solver = python_command(program) if program.suffix == ".py" else (str(program.absolute()),)
    print(f"{'case':42} {'read s':>8} {'solve s':>8} {'ratio':>6}")
    for case in cases:
        pairs = [
            (cpu_s(READER, case.input), cpu_s(solver, case.input)) for _ in range(options.runs)
        ]
        read_s, solve_s = (statistics.median(column) for column in zip(*pairs, strict=True))
        ratio = statistics.median(solve / read for read, solve in pairs)
        print(f"{case.name:42} {read_s:8.3f} {solve_s:8.3f} {ratio:6.2f}", flush=True)
    return MEASURED


def cpu_s(command: Sequence[str], file: Path) -> float:
    """Run a command with the file as its input; return its CPU seconds. Raises BenchError."""
    with file.open("rb") as stdin:
        process = subprocess.Popen(command, stdin=stdin, stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise BenchError(f"{command[-1]}: exit status {process.returncode} on {file}")
    return usage.ru_utime + usage.ru_stime
