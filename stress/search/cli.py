"""`python -m stress my.cpp`: searches for a smallest scenario that a program gets wrong."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from judge.judging import wait_until_ready
from judge.kit.command import Parser, add_jobs, complain, whole_number
from judge.kit.console import PlainConsole
from judge.kit.processors import cores
from judge.kit.progress import progress_bar
from judge.languages.submission import CompileError, Submission, read_submission
from judge.languages.table import by_name
from judge.pool import Job, Pool
from judge.problem.declaration import load
from judge.reports.explained import print_counterexample
from judge.run import declared_limits
from stress.running.trial import Subject
from stress.search.search import DRAWING_S, Result, search
from stress.search.session import new_seed, with_addition

RIGHT, WRONG = 0, 1


def command(arguments: Sequence[str]) -> int:
    """Search, print what is found, and return 0 if that is nothing, else 1. Raises KitError."""
    asked = _options(arguments)
    problem = load()
    language = None if asked.language is None else by_name(asked.language)
    submission = read_submission(Path(asked.program), language)
    seed = new_seed() if asked.seed is None else asked.seed
    job = Job(submission, problem, without_wall=asked.no_wall, keepers=asked.jobs)
    with progress_bar(f"compiling {submission.name}") as bar, Pool(job, asked.jobs) as pool:
        _compile(pool, submission)
        subject = Subject(pool.attempts, declared_limits(problem.limits))
        result = search(subject, (), seed=seed, drawing_s=asked.seconds, say=bar.say)
    return _tell(result, seed, asked)


def _compile(pool: Pool, submission: Submission) -> None:
    """Wait until it is compiled. Raises JudgeError where no wall works, CompileError."""
    ready = wait_until_ready(pool, pool.prepare(), submission)
    if ready.compile_error:
        for line in ready.compile_error.splitlines():
            complain(line)
        raise CompileError(f"{submission.name}: does not compile")


def _tell(result: Result, seed: int, asked: argparse.Namespace) -> int:
    found = result.counterexample
    if found is not None:
        if asked.add:
            found = with_addition(found, asked.group)
        print_counterexample(PlainConsole(), found)
        return WRONG
    if result.failed:
        print(f"{asked.program}: {result.remark} (seed {seed})")
        return WRONG
    print(f"{asked.program}: {result.answered:,} scenarios answered correctly (seed {seed})")
    return RIGHT


def _options(arguments: Sequence[str]) -> argparse.Namespace:
    parser = Parser(
        prog="python -m stress",
        description="Draw scenarios until the program gets one wrong; shrink that one. "
        "Exit status: 0 nothing found, 1 found, 2 failed.",
        epilog="Other commands: python -m stress random, world, complete, all, table. A program "
        "of such a name is given as ./random.",
    )
    add = parser.add_argument
    add("program", help="source file of the program to search for")
    add("--seed", type=whole_number(0), metavar="N", help="search as the seed N did")
    add(
        "--seconds",
        type=whole_number(1, 86_400),
        default=int(DRAWING_S),
        metavar="S",
        help=f"draw scenarios for so long (default {DRAWING_S:.0f})",
    )
    add("--language", metavar="NAME", help="language (default: by suffix, else by the text)")
    add("--add", action="store_true", help="add what is found to data/, with the manifest")
    add("--group", default="", metavar="NAME", help="--add: the group (default: the first to fit)")
    add("--no-wall", action="store_true", help="run the program even if no wall works here")
    add_jobs(parser, cores(), "runs")
    asked = parser.parse_args(arguments)
    if asked.group and not asked.add:
        parser.error("argument --group: expected --add, too")
    return asked
