"""How the time of three methods grows with the input: `python -m bench growth`.

Two experiments, ladders of `stress/growth/`: on their scenes obstacles surround the robot closely
and none is touched, so that no method can stop early:

  pair       a robot of n vertices and one obstacle of n vertices
  triangles  a robot of n vertices among n / 3 triangles

Each method gets sizes that it can do in a few seconds. Measured is CPU time without the start of
Python; the least of some runs counts, as disturbances only add time. The exponent b of a * n^b is
fitted to the logarithms by least squares. Written are docs/figures/growth.svg and growth.json.
"""

from __future__ import annotations

import argparse
import platform
import sys
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import msgspec

from bench.measure import cpu_s
from bench.plot import Curve, Panel, plot
from gen.scenario import render
from judge.kit.command import Parser, run, whole_number
from judge.kit.files import FileError, write_whole
from judge.kit.paths import BRUTE_FORCE, REFERENCE, ROOT, SUBMISSIONS
from judge.kit.trusted import python_command
from stress.growth.ladders import BY_NAME, exponent

METHODS = {
    "naive": BRUTE_FORCE,
    "textbook": SUBMISSIONS / "accepted" / "textbook.py",
    "reference": REFERENCE,
}
SLOW = 200, 400, 800, 1600
MIDDLE = 600, 1200, 2400, 4800
FAST = 25_000, 50_000, 100_000, 200_000
SIZES = {
    "pair": {"naive": SLOW, "textbook": FAST, "reference": FAST},
    "triangles": {"naive": SLOW, "textbook": MIDDLE, "reference": FAST},
}
TITLES = {
    "pair": "robot of n vertices, one obstacle of n vertices",
    "triangles": "robot of n vertices, n / 3 triangles",
}
FIGURES = ROOT / "docs" / "figures"
EMPTY = (sys.executable, "-c", "pass")
MEASURED = 0


@dataclass(frozen=True)
class Growth:
    """The seconds of one method at each size, and the fitted exponent."""

    experiment: str
    method: str
    sizes: list[int]
    cpu_s: list[float]
    exponent: float


def main(arguments: Sequence[str]) -> int:
    """Run the command line; return the exit status: 0 measured, 2 usage."""
    return run("bench growth", lambda: _measure(_options(arguments)))


def _options(arguments: Sequence[str]) -> argparse.Namespace:
    parser = Parser(
        prog="python -m bench growth",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--runs", type=whole_number(1), default=3, help="of each file (default 3)")
    parser.add_argument(
        "--part", type=whole_number(1), default=1, help="divide all sizes by this (default 1)"
    )
    parser.add_argument(
        "--output", type=Path, default=FIGURES, metavar="DIR", help="where to write the two files"
    )
    return parser.parse_args(arguments)


def _measure(options: argparse.Namespace) -> int:
    """Measure everything, print it, write both files. Raises BenchError, FileError, OSError."""
    if not options.output.is_dir():
        raise FileError(f"{options.output}: no such directory")
    results = []
    with tempfile.TemporaryDirectory() as directory:
        file = Path(directory, "scene.in")
        file.write_bytes(b"")
        start_s = min(cpu_s(EMPTY, file) for _ in range(options.runs))
        for experiment, methods in SIZES.items():
            for method, full_sizes in methods.items():
                sizes = [max(6, size // options.part) for size in full_sizes]
                seconds = []
                for size in sizes:
                    file.write_bytes(render(BY_NAME[experiment].make(size)))
                    command = python_command(METHODS[method])
                    least = min(cpu_s(command, file) for _ in range(options.runs))
                    seconds.append(round(max(least - start_s, 0.0001), 4))
                growth = Growth(experiment, method, sizes, seconds, exponent(sizes, seconds))
                results.append(growth)
                shown = "  ".join(f"{n:,}: {s:.3f} s" for n, s in zip(sizes, seconds, strict=True))
                print(f"{experiment:10} {method:10} n^{growth.exponent:.2f}   {shown}", flush=True)
    facts = {"python": platform.python_version(), "runs": options.runs, "growth": results}
    report = msgspec.json.format(msgspec.json.encode(facts), indent=2) + b"\n"
    write_whole(options.output / "growth.json", report)
    write_whole(options.output / "growth.svg", _picture(results).encode())
    return MEASURED


def _picture(results: Sequence[Growth]) -> str:
    panels = []
    for experiment, title in TITLES.items():
        curves = [
            Curve(f"{g.method}: n^{g.exponent:.2f}", g.sizes, g.cpu_s)
            for g in results
            if g.experiment == experiment
        ]
        panels.append(Panel(title, curves))
    return plot(panels, "CPU seconds against n")
