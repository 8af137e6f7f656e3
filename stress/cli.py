"""Programs against each other: `python -m stress random`, `world`, `complete`, or `all`.

random: tiny random scenarios; world: a complete small world; both for Python programs.
complete: larger complete worlds for C++ programs, and parts of them for Python programs.
all: random and world.

`python -m stress my.cpp` searches for a smallest scenario that a program gets wrong, and
`python -m stress table` does so for every wrong submission: see `stress.search`.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
from pathlib import Path
from typing import NamedTuple

from judge.kit.command import Parser, add_jobs, run, whole_number
from judge.kit.paths import REFERENCE
from judge.kit.processors import processors
from judge.kit.progress import progress_bar
from judge.sandbox.sandbox import Sandbox
from stress.chance import random_files
from stress.compare import File, Outcome, Program, compare, keep
from stress.programs import CPP, PYTHON, ready
from stress.worlds import World, box_world, grid_world

COMPARISONS = ("random", "world", "complete", "all")
AGREED, DISAGREED = 0, 1
LEAST_SIDE, MOST_SIDE = 2, 4  # of the grids of complete worlds
WORLD_PART = 31_250  # scenarios: of at most 16 vertices each, so 5 * 10^5 in a file

# (robot's side, obstacle's side, reach), by number of scenarios.
COMPLETE = ((2, 2, 4), (3, 3, 4), (4, 3, 2), (3, 4, 2), (4, 4, 1))


class Task(NamedTuple):
    """What to compare on: the files, and how many scenarios they hold together."""

    name: str
    files: Iterable[File]
    scenarios: int


def main(arguments: Sequence[str]) -> int:
    """Run the command line; return the exit status: 0 agreed, 1 disagreed, 2 failed."""

    def command() -> int:
        if not set(COMPARISONS) & set(arguments):
            return _search_command(arguments)
        options = _options(arguments)
        with Sandbox() as sandbox:
            programs = _programs(options, sandbox)
            return max([_compare(task, programs, options.jobs) for task in _tasks(options)])

    return run("stress", command, interrupted="interrupted, nothing is left running")


def _search_command(arguments: Sequence[str]) -> int:
    """Search for a counterexample of one program, or of each submission: commands of a room."""
    from stress.search import cli, table

    return table.command(arguments[1:]) if arguments[:1] == ["table"] else cli.command(arguments)


def _options(arguments: Sequence[str]) -> argparse.Namespace:
    parser = Parser(
        prog="python -m stress",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("what", choices=COMPARISONS)
    add("--seeds", type=whole_number(1), default=10, help="random: how many (default 10)")
    add(
        "--scenarios",
        type=whole_number(1),
        default=100_000,
        help="random: for each seed (default 100000)",
    )
    add(
        "--side",
        type=whole_number(LEAST_SIDE),
        default=3,
        help="world: points a side of the grid (default 3)",
    )
    add("--reach", type=whole_number(0), default=2, help="world: of the moves (default 2)")
    add(
        "--solver",
        type=Path,
        action="append",
        help="random, world: a program to compare; repeat it, as one alone is compared with "
        "solution.py (default: solution.py, brute.py, textbook.py)",
    )
    add(
        "--grids",
        type=whole_number(0),
        nargs=3,
        metavar=("ROBOT", "OBSTACLE", "REACH"),
        help=f"complete: only this world: points a side ({LEAST_SIDE} to {MOST_SIDE}) of both "
        "grids, reach of the moves (default: all planned worlds)",
    )
    add(
        "--python-every",
        type=whole_number(0),
        default=100,
        metavar="N",
        help="complete: the Python programs answer every N-th part (default 100; 0: none)",
    )
    add_jobs(parser, processors(), "files answered")
    options = parser.parse_args(arguments)
    for side in (options.grids or ())[:2]:
        if not LEAST_SIDE <= side <= MOST_SIDE:
            parser.error(
                f"argument --grids: expected {LEAST_SIDE} to {MOST_SIDE} points a side, "
                f"found {side}"
            )
    return options


def _programs(options: argparse.Namespace, sandbox: Sandbox) -> list[Program]:
    if options.what != "complete":
        paths = options.solver or PYTHON
        return ready(paths if len(paths) > 1 else [REFERENCE, *paths], sandbox)
    programs = ready(CPP, sandbox)
    if options.python_every:
        programs += ready(PYTHON, sandbox, options.python_every)
    return programs


def _tasks(options: argparse.Namespace) -> Iterator[Task]:
    if options.what in ("random", "all"):
        seeds = range(1, options.seeds + 1)
        files = chain.from_iterable(random_files(seed, options.scenarios) for seed in seeds)
        which = "seed 1" if options.seeds == 1 else f"{options.seeds} seeds"
        name = f"random scenarios from {which}"
        yield Task(name, files, options.seeds * options.scenarios)
    if options.what in ("world", "all"):
        yield _whole(grid_world(options.side, options.reach))
    if options.what == "complete":
        for sides_and_reach in [options.grids] if options.grids else COMPLETE:
            yield _whole(box_world(*sides_and_reach))


def _whole(world: World) -> Task:
    return Task(str(world), world.files(WORLD_PART), world.size)


def _compare(task: Task, programs: Sequence[Program], jobs: int) -> int:
    """Compare the programs, print the outcome, and return the exit status."""
    start = time.perf_counter()
    with progress_bar(task.name, task.scenarios) as bar:
        outcome = compare(task.files, programs, jobs=jobs, progress=bar.advance)
    seconds = time.perf_counter() - start
    print(f"{task.name}: {_result(outcome, programs)}, {seconds:.0f} s", flush=True)
    return AGREED if outcome.disagreement is None else DISAGREED


def _result(outcome: Outcome, programs: Sequence[Program]) -> str:
    """Return the outcome in words; keep the scenario that programs disagree about."""
    compared = f"{outcome.scenarios:,} scenarios ({outcome.yes:,} YES)"
    if outcome.disagreement is not None:
        answers = ", ".join(f"{name}: {answer}" for name, answer in outcome.disagreement.answers)
        return f"{answers}; the scenario is kept in {keep(outcome.disagreement)}; {compared}"
    answered: dict[int, list[str]] = {}
    for program, scenarios in zip(programs, outcome.answered, strict=True):
        answered.setdefault(scenarios, []).append(program.name)
    everything, *parts = answered.items()
    text = f"{', '.join(everything[1])} agree on {compared}"
    for scenarios, names in parts:
        text += f", {', '.join(names)} on {scenarios:,} of them"
    return text
