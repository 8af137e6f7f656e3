"""Solvers against each other: `python -m stress random`, `python -m stress world`, or `all`."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterable
from itertools import chain
from pathlib import Path

from gen.scenario import Scenario
from stress.agree import SOLVERS, SolverError, compare, keep
from stress.worlds import random_scenarios, small_world


def main() -> int:
    """Run the command line; return the exit status: 0 agreed, 1 disagreed, 2 failed."""
    parser = argparse.ArgumentParser(prog="python -m stress", description=__doc__)
    parser.add_argument("what", choices=["random", "world", "all"])
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
    arguments = parser.parse_args()
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
    try:
        return max([_compare(name, scenarios, solvers) for name, scenarios in worlds])
    except SolverError as error:
        print(f"stress: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("stress: interrupted", file=sys.stderr)
        return 2


def _compare(name: str, scenarios: Iterable[Scenario], solvers: list[Path]) -> int:
    """Compare on one set, print the outcome, and return the exit status."""
    start = time.perf_counter()
    agreement = compare(scenarios, solvers)
    seconds = time.perf_counter() - start
    done = f"{agreement.scenarios:,} scenarios ({agreement.yes:,} YES), {seconds:.0f} s"
    if agreement.disagreement is None:
        print(f"{name}: {', '.join(solver.name for solver in solvers)} agree on {done}")
        return 0
    kept = keep(agreement.disagreement)
    answers = ", ".join(f"{who}: {what}" for who, what in agreement.disagreement.answers.items())
    print(f"{name}: {answers}; the scenario is kept in {kept}; {done}")
    return 1


if __name__ == "__main__":
    sys.exit(main())
