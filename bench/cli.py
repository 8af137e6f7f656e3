"""How much longer a solution takes than reading its input: `python -m bench [GLOB ...]`.

Seconds differ from machine to machine and from minute to minute; the ratio to reading the
same file in the same run hardly does. Each file is read by a bare
`list(map(int, sys.stdin.buffer.read().split()))` and then solved. The ratio of the CPU
seconds is taken for each such pair of runs, and the median ratio is printed.

`python -m bench growth` measures how the time of three methods grows with the input.
"""

from __future__ import annotations

import argparse
import statistics
import sys
from collections.abc import Sequence
from pathlib import Path

from bench import growth
from bench.measure import cpu_s
from judge.kit.command import Parser, run, whole_number
from judge.kit.paths import REFERENCE
from judge.kit.store import Store
from judge.kit.trusted import python_command
from judge.problem.data import load_data
from judge.problem.declaration import load

READER = (sys.executable, "-c", "import sys; list(map(int, sys.stdin.buffer.read().split()))")
GROWTH = "growth"
MEASURED = 0


def main(arguments: Sequence[str]) -> int:
    """Run the command line; return the exit status: 0 measured, 2 nothing to measure."""
    if arguments[:1] == [GROWTH]:
        return growth.main(arguments[1:])
    return run("bench", lambda: _measure(_options(arguments)))


def _options(arguments: Sequence[str]) -> argparse.Namespace:
    parser = Parser(
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
