"""Do verdicts hold on a busy machine? `python -m bench.fairness`.

A program is timed on a quiet machine. Then, with a busy process on every processor, it is
judged many times under two limits that leave exactly the margins that problem.toml declares:
`ac_to_time_limit` times its quiet time, where every judging must accept it, and its quiet
time over `time_limit_to_tle`, where none may. Neither limit is scaled: the speed of a machine
is measured once and kept, so load does not change the limit of a judging.
"""

from __future__ import annotations

import argparse
import statistics
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from judge.judging import Options, judge
from judge.kit.command import Parser, run, whole_number
from judge.kit.paths import SUBMISSIONS
from judge.kit.processors import cores, processors
from judge.languages.submission import Submission, read_submission
from judge.problem.declaration import Problem, load
from judge.problem.verdict import Verdict
from judge.results import Judging

QUIET_RUNS = 3
QUIET_LIMIT_S = 100.0
FAIR, UNFAIR = 0, 1


def main(arguments: Sequence[str]) -> int:
    """Run the command line; return 0 if no verdict was wrong, 1 if one was, 2 failed."""
    return run("fairness", lambda: _measure(_options(arguments)))


def _options(arguments: Sequence[str]) -> argparse.Namespace:
    parser = Parser(
        prog="python -m bench.fairness",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--program", type=Path, default=SUBMISSIONS / "accepted" / "textbook.py")
    parser.add_argument("--case", default="secret/large/01-largest", metavar="GLOB")
    parser.add_argument(
        "--judgings", type=whole_number(1), default=20, help="for each limit (default 20)"
    )
    return parser.parse_args(arguments)


def _measure(options: argparse.Namespace) -> int:
    problem, submission = load(), read_submission(options.program)
    quiet_s = min(
        judging.cases[0].cpu_s
        for judging in _judgings(submission, problem, options.case, QUIET_LIMIT_S, QUIET_RUNS)
    )
    print(f"quiet: {quiet_s:.2f} s of CPU time, {options.program.name} on {options.case}")
    multipliers = problem.limits.time_multipliers
    wrong = 0
    for expected, limit_s in (
        (Verdict.AC, quiet_s * multipliers.ac_to_time_limit),
        (Verdict.TLE, quiet_s / multipliers.time_limit_to_tle),
    ):
        with _busy_processors() as processes:
            done = list(_judgings(submission, problem, options.case, limit_s, options.judgings))
        verdicts = Counter(judging.verdict.value for judging in done)
        cpu_s = [judging.cases[0].cpu_s for judging in done]
        repeated = sum(judging.cases[0].retried for judging in done)
        changed = sum(len(judging.changed) for judging in done)
        print(
            f"{processes} busy, limit {limit_s:.2f} s, expected {expected}: {dict(verdicts)}; "
            f"{min(cpu_s):.2f} to {max(cpu_s):.2f} s, median {statistics.median(cpu_s):.2f} s; "
            f"{repeated} repeated, {changed} changed",
            flush=True,
        )
        wrong += sum(judging.verdict is not expected for judging in done)
    return UNFAIR if wrong else FAIR


def _judgings(
    submission: Submission, problem: Problem, case: str, limit_s: float, times: int
) -> Iterator[Judging]:
    """Judge on one case, again and again."""
    options = Options(globs=(case,), time_limit_s=limit_s, jobs=cores())
    for _ in range(times):
        yield judge(submission, problem, options)


@contextmanager
def _busy_processors() -> Iterator[int]:
    """Keep every processor busy; yield the number of processes that do."""
    loop = [sys.executable, "-c", "while True: pass"]
    processes = [subprocess.Popen(loop) for _ in range(processors())]
    try:
        yield len(processes)
    finally:
        for process in processes:
            process.kill()
            process.wait()
