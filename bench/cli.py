"""How much longer a solution takes than reading its input: `python -m bench [GLOB ...]`.

Seconds differ from machine to machine and from minute to minute; the ratio to
reading the same file in the same run does not much. Each file is read by a bare
`list(map(int, sys.stdin.buffer.read().split()))` and solved, in turn; the ratio of
CPU seconds is taken pair by pair, and the median is printed.
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
from pathlib import Path

from judge.kit.paths import ROOT

READER = "import sys; list(map(int, sys.stdin.buffer.read().split()))"


def main() -> int:
    """Run the command line; return the exit status: 0 measured, 2 nothing to measure."""
    parser = argparse.ArgumentParser(prog="python -m bench", description=__doc__.split("\n")[0])
    parser.add_argument(
        "globs",
        nargs="*",
        default=["secret/large/*", "secret/many/*"],
        metavar="GLOB",
        help="cases below data/ (default: secret/large/* and secret/many/*)",
    )
    parser.add_argument("--runs", type=int, default=5, help="pairs of runs (default 5)")
    parser.add_argument("--program", type=Path, default=ROOT / "solution.py")
    arguments = parser.parse_args()
    data = ROOT / "data"
    files = sorted({f for glob in arguments.globs for f in data.glob(f"{glob}.in")})
    if not files:
        print("bench: no such cases; the large ones are built by 'make data'", file=sys.stderr)
        return 2
    print(f"{'case':42} {'read s':>8} {'solve s':>8} {'ratio':>6}")
    for file in files:
        pairs = [
            (cpu_s([sys.executable, "-c", READER], file), cpu_s(command(arguments.program), file))
            for _ in range(arguments.runs)
        ]
        read_s, solve_s = (statistics.median(column) for column in zip(*pairs, strict=True))
        ratio = statistics.median(solve / read for read, solve in pairs)
        name = str(file.relative_to(data).with_suffix(""))
        print(f"{name:42} {read_s:8.3f} {solve_s:8.3f} {ratio:6.2f}", flush=True)
    return 0


def command(program: Path) -> list[str]:
    """Return the command of a Python program, or of an executable."""
    return [sys.executable, str(program)] if program.suffix == ".py" else [str(program)]


def cpu_s(command: list[str], file: Path) -> float:
    """Run a command with the file as its input; return its CPU seconds."""
    with file.open("rb") as stdin:
        process = subprocess.Popen(command, stdin=stdin, stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        sys.exit(f"bench: {command[-1]} failed on {file}")
    return usage.ru_utime + usage.ru_stime


if __name__ == "__main__":
    sys.exit(main())
