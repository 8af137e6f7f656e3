"""Solvers against each other: `python -m stress random`, `world`, `complete`, or `all`.

random: random tiny scenarios; world: a complete small world for the Python programs;
complete: larger complete worlds for the C++ programs, parts of them for Python too;
all: random and world.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Iterable
from functools import partial
from itertools import chain
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn

from gen.scenario import Scenario
from judge.kit.command import run
from judge.languages.table import LanguageError
from judge.problem.declaration import SpecError, load
from judge.sandbox.sandbox import Sandbox, SandboxError
from stress.agree import SOLVERS, Disagreement, SolverError, compare, keep
from stress.complete import WORLDS, World, compare_world, compiled, size
from stress.worlds import random_scenarios, small_world


def main() -> int:
    """Run the command line; return the exit status: 0 agreed, 1 disagreed, 2 failed."""
    parser = argparse.ArgumentParser(
        prog="python -m stress",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("what", choices=["random", "world", "complete", "all"])
    parser.add_argument("--seeds", type=int, default=10, help="random: how many (default 10)")
    parser.add_argument(
        "--scenarios", type=int, default=100_000, help="random: for each seed (default 100000)"
    )
    parser.add_argument("--side", type=int, default=3, help="world: side of the grid (default 3)")
    parser.add_argument("--reach", type=int, default=2, help="world: of the moves (default 2)")
    parser.add_argument(
        "--solver",
        type=Path,
        action="append",
        help="a Python program; repeat it (default: solution.py, brute.py, textbook.py)",
    )
    parser.add_argument(
        "--grids",
        type=int,
        nargs=3,
        metavar=("ROBOT", "OBSTACLE", "REACH"),
        help="complete: only this world: points a side (2 to 4) of both grids, reach of the moves "
        "(default: all worlds that are planned)",
    )
    parser.add_argument(
        "--python-every",
        type=int,
        default=100,
        metavar="N",
        help="complete: the Python programs answer every N-th part (default 100; 0: none)",
    )
    parser.add_argument(
        "--jobs", type=int, default=len(os.sched_getaffinity(0)), help="complete: parts at a time"
    )
    arguments = parser.parse_args()
    command = _complete if arguments.what == "complete" else _in_python
    errors = (SolverError, SpecError, LanguageError, SandboxError)
    return run("stress", partial(command, arguments), errors)


def _in_python(arguments: argparse.Namespace) -> int:
    """Compare the Python programs; return the exit status."""
    solvers = arguments.solver or list(SOLVERS)
    worlds: list[tuple[str, Iterable[Scenario]]] = []
    if arguments.what != "world":
        seeds = range(1, arguments.seeds + 1)
        every = chain.from_iterable(random_scenarios(seed, arguments.scenarios) for seed in seeds)
        worlds.append((f"random scenarios from {arguments.seeds} seeds", every))
    if arguments.what != "random":
        grid = f"{arguments.side} x {arguments.side}"
        name = f"all pairs on {grid} grids, all displacements within +-{arguments.reach}"
        worlds.append((name, small_world(arguments.side, arguments.reach)))
    return max([_compare(name, scenarios, solvers) for name, scenarios in worlds])


def _complete(arguments: argparse.Namespace) -> int:
    """Compare the C++ programs on complete worlds; return the exit status."""
    worlds = [World(*arguments.grids)] if arguments.grids else list(WORLDS)
    columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn())
    status = 0
    with Sandbox() as sandbox:
        programs = compiled(load(), sandbox)
        for world in worlds:
            start = time.perf_counter()
            console = Console(stderr=True)
            with Progress(*columns, console=console, transient=True) as progress:
                task = progress.add_task(str(world), total=size(world, programs))
                outcome = compare_world(
                    world,
                    programs,
                    jobs=arguments.jobs,
                    python_every=arguments.python_every,
                    progress=partial(progress.advance, task),
                )
            seconds = time.perf_counter() - start
            names = [*programs.solvers]
            if outcome.by_python:
                names.append(f"and on {outcome.by_python:,} the Python ones")
            done = f"{outcome.scenarios:,} scenarios ({outcome.yes:,} YES), {seconds:.0f} s"
            status = max(status, _tell(str(world), names, outcome.disagreement, done))
    return status


def _compare(name: str, scenarios: Iterable[Scenario], solvers: list[Path]) -> int:
    """Compare on one set, print the outcome, and return the exit status."""
    start = time.perf_counter()
    agreement = compare(scenarios, solvers)
    seconds = time.perf_counter() - start
    done = f"{agreement.scenarios:,} scenarios ({agreement.yes:,} YES), {seconds:.0f} s"
    return _tell(name, [solver.name for solver in solvers], agreement.disagreement, done)


def _tell(name: str, solvers: list[str], disagreement: Disagreement | None, done: str) -> int:
    """Print one outcome and return its exit status."""
    if disagreement is None:
        print(f"{name}: {', '.join(solvers)} agree on {done}", flush=True)
        return 0
    kept = keep(disagreement)
    answers = ", ".join(f"{who}: {what}" for who, what in disagreement.answers.items())
    print(f"{name}: {answers}; the scenario is kept in {kept}; {done}")
    return 1


if __name__ == "__main__":
    sys.exit(main())
