"""Do verdicts hold on a busy machine? `python -m bench.fairness`.

A program is timed on a quiet machine. Then, with a busy process on every processor, it is
judged many times under two limits that leave it exactly the margins the declaration asks
for: `ac_to_time_limit` times its quiet time, where every judging must accept it, and its
quiet time over `time_limit_to_tle`, where none may. Limits are scaled by the reference's
time under the same load, as in every judging.
"""

from __future__ import annotations

import argparse
import os
import statistics
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from judge.judging import Options, default_jobs, judge, machine_scale
from judge.kit.paths import ROOT
from judge.languages.submission import Submission, read_submission
from judge.problem.declaration import Problem, load
from judge.problem.verdict import Verdict
from judge.results import Judging
from judge.sandbox.probe import probe
from judge.sandbox.sandbox import Sandbox

QUIET_RUNS = 3
QUIET_LIMIT_S = 100.0


def main() -> int:
    """Run the command line; return 0 if no verdict was wrong, 1 if one was."""
    parser = argparse.ArgumentParser(prog="python -m bench.fairness", description=__doc__)
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument("--program", type=Path, default=ROOT / "submissions/accepted/textbook.py")
    parser.add_argument("--case", default="secret/large/01-largest", metavar="GLOB")
    parser.add_argument("--judgings", type=int, default=20, help="for each limit (default 20)")
    asked = parser.parse_args()
    problem, submission = load(), read_submission(asked.program)
    quiet_s = min(
        judging.cases[0].cpu_s
        for judging in judgings(submission, problem, asked.case, QUIET_LIMIT_S, QUIET_RUNS)
    )
    print(f"quiet: {quiet_s:.2f} s of CPU time, {asked.program.name} on {asked.case}")
    wrong = 0
    multipliers = problem.limits.time_multipliers
    for expected, limit_s in (
        (Verdict.AC, quiet_s * multipliers.ac_to_time_limit),
        (Verdict.TLE, quiet_s / multipliers.time_limit_to_tle),
    ):
        with busy_processors() as processes:
            done = list(judgings(submission, problem, asked.case, limit_s, asked.judgings))
        verdicts = Counter(judging.verdict.value for judging in done)
        cpu_s = [judging.cases[0].cpu_s for judging in done]
        scales = sorted(judging.time_limit_s / limit_s for judging in done)
        retried = sum(judging.cases[0].retried for judging in done)
        changed = sum(len(judging.changed) for judging in done)
        print(
            f"{processes} busy, limit {limit_s:.2f} s x {scales[0]:.2f} to {scales[-1]:.2f}, "
            f"expected {expected}: {dict(verdicts)}; {min(cpu_s):.2f} to {max(cpu_s):.2f} s, "
            f"median {statistics.median(cpu_s):.2f} s; {retried} run again, {changed} changed",
            flush=True,
        )
        wrong += sum(judging.verdict is not expected for judging in done)
    return 1 if wrong else 0


def judgings(
    submission: Submission, problem: Problem, case: str, limit_s: float, times: int
) -> Iterator[Judging]:
    """Judge on one case, again and again, each time under a limit scaled anew."""
    for _ in range(times):
        with Sandbox(probe().wall) as sandbox:
            scale = machine_scale(problem, sandbox) or 1.0
        options = Options(globs=(case,), time_limit_s=limit_s * scale, jobs=default_jobs())
        yield judge(submission, problem, options)


@contextmanager
def busy_processors() -> Iterator[int]:
    """Keep every processor busy; yield the number of processes that do."""
    loop = [sys.executable, "-c", "while True: pass"]
    processes = [subprocess.Popen(loop) for _ in os.sched_getaffinity(0)]
    try:
        yield len(processes)
    finally:
        for process in processes:
            process.kill()
            process.wait()


if __name__ == "__main__":
    sys.exit(main())
