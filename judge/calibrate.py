"""Measures what the time limit rests on: `make calibrate`, or `python -m judge.calibrate`.

Every submission declared AC or TLE in a group is timed there. The limit must be
`ac_to_time_limit` times the slowest accepted run, and the fastest slow submission must
take `time_limit_to_tle` times the limit (the time multipliers of the Kattis problem
package format). A slow one is ended at BOUND_FACTOR times what is asked of it, and on its
first case over that: it takes "at least" so long. The scale of this machine that was kept for
judgings is forgotten.
"""

from __future__ import annotations

import argparse
import math
import re
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

from rich.console import Console
from rich.table import Table

from judge.judging import JudgeError
from judge.kit.command import run
from judge.kit.files import write_whole
from judge.kit.paths import PROBLEM_FILE, SUBMISSIONS
from judge.kit.store import Store
from judge.languages.submission import compile_submission, read_submission
from judge.machine import forget_scale, reference_cpu_s
from judge.problem.cases import Case
from judge.problem.data import load_data
from judge.problem.declaration import Problem, load
from judge.problem.verdict import Verdict
from judge.run import run_case
from judge.sandbox.facts import RunLimits
from judge.sandbox.probe import probe
from judge.sandbox.sandbox import Sandbox

BOUND_FACTOR = 2.0
STEP_S = 0.5  # limits are multiples of this


@dataclass(frozen=True, slots=True)
class Time:
    """The slowest run of a submission in a group. at_least: it was ended at `cpu_s`."""

    submission: str
    group: str
    expected: Verdict
    case: str
    cpu_s: float
    at_least: bool


@dataclass(frozen=True, slots=True)
class Margins:
    """What the limit must lie between: `slowest` accepted and `fastest` slow one."""

    slowest: Time
    fastest: Time | None
    least_s: float
    most_s: float

    def fits(self, limit_s: float) -> bool:
        """Does this limit keep both margins?"""
        return self.least_s <= limit_s <= self.most_s

    def proposal(self, declared_s: float) -> float | None:
        """Return the declared limit if it fits, else the least that does, else None."""
        rounded_s = math.ceil(self.least_s / STEP_S) * STEP_S
        return next((s for s in (declared_s, rounded_s) if self.fits(s)), None)


def margins(times: Sequence[Time], problem: Problem) -> Margins:
    """Return the margins that `times` leave. Raises JudgeError if nothing accepted was timed."""
    asked = problem.limits.time_multipliers
    accepted = [time for time in times if time.expected is Verdict.AC]
    slow = [time for time in times if time.expected is Verdict.TLE]
    if not accepted:
        raise JudgeError("no accepted submission was timed: there is nothing to set a limit by")
    slowest = max(accepted, key=lambda time: time.cpu_s)
    fastest = min(slow, key=lambda time: time.cpu_s, default=None)
    most_s = math.inf if fastest is None else fastest.cpu_s / asked.time_limit_to_tle
    return Margins(slowest, fastest, slowest.cpu_s * asked.ac_to_time_limit, most_s)


def measure(
    name: str,
    problem: Problem,
    cases: Sequence[Case],
    sandbox: Sandbox,
    tell: Callable[[Time], None],
) -> list[Time]:
    """Time the submission `name` (below submissions/) in every group where it is AC or TLE.

    Raises CompileError, LanguageError, SandboxError; JudgeError for another verdict than declared.
    """
    path = SUBMISSIONS / name
    program = compile_submission(read_submission(path), problem.limits, sandbox)
    over_s = problem.limits.time_limit_s * problem.limits.time_multipliers.time_limit_to_tle
    limits = RunLimits(over_s * BOUND_FACTOR, problem.limits.memory_mib, problem.limits.output_mib)
    times = []
    for group in problem.group_names:
        expected = problem.expected(name, group)
        own = [case for case in cases if case.group == group]
        if not own or expected not in ({Verdict.AC}, {Verdict.TLE}):
            continue
        runs = []
        for case in sorted(own, key=_size, reverse=True):  # what is slow is slow there first
            result = run_case(sandbox, program, limits, case)
            ended = result.verdict is Verdict.TLE
            if result.verdict is not Verdict.AC and expected != {result.verdict}:
                said = f"{result.verdict} ({result.message})"
                raise JudgeError(f"{name}: {case.name}: expected {min(expected)}, found {said}")
            runs.append(Time(name, group, min(expected), case.name, result.cpu_s, ended))
            if ended:
                break
        times.append(max(runs, key=lambda time: time.cpu_s))
        tell(times[-1])
    return times


def _size(case: Case) -> int:
    return case.input.stat().st_size


def written(text: str, limit_s: float, reference_s: float) -> str:
    r"""Return the text of problem.toml with both figures in place, and nothing else changed.

    >>> written("time_limit_s = 5.0  # why\\nreference_cpu_s = 1.0\\n", 4.5, 0.25)
    'time_limit_s = 4.5  # why\\nreference_cpu_s = 0.25\\n'
    """
    for key, value in (("time_limit_s", limit_s), ("reference_cpu_s", reference_s)):
        text, found = re.subn(rf"(?m)^({key}\s*=\s*)[\d._]+", rf"\g<1>{value}", text)
        if found != 1:
            raise JudgeError(f"problem.toml: expected one line `{key} = …`, found {found}")
    return text


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; return 0 when a limit fits, 1 when none does, 2 on an error."""
    parser = argparse.ArgumentParser(
        prog="python -m judge.calibrate", description="Measure the margins of the time limit."
    )
    parser.add_argument("--write", action="store_true", help="write the figures to problem.toml")
    parser.add_argument(
        "--only", metavar="TEXT", default="", help="submissions whose name has TEXT"
    )
    command = partial(_calibrate, parser, arguments)
    return run("calibrate", command, interrupted="interrupted, nothing was written")


def _calibrate(parser: argparse.ArgumentParser, arguments: Sequence[str] | None) -> int:
    asked = parser.parse_args(arguments)
    only, write = asked.only, asked.write
    problem = load()
    names = [
        name
        for name in problem.submissions
        if name.startswith(("accepted/", "time_limit_exceeded/")) and only in name
    ]
    if not names:
        raise JudgeError(f"--only {only!r}: expected part of a name in accepted/ or a slow one's")
    with Store() as store:
        cases = load_data(problem, store=store).chosen
    console = Console(highlight=False, soft_wrap=True)
    forget_scale()  # the next judging that needs it measures this machine again
    with Sandbox(probe().wall) as sandbox:
        reference_s = round(reference_cpu_s(problem, sandbox), 2)
        console.print(f"reference on {problem.calibration.case}: {reference_s} s of CPU time")
        times = [
            time
            for name in names
            for time in measure(name, problem, cases, sandbox, lambda t: console.print(_line(t)))
        ]
    found = margins(times, problem)
    declared_s = problem.limits.time_limit_s
    console.print(_table(found, declared_s, problem))
    proposal_s = found.proposal(declared_s)
    if proposal_s is None:
        console.print("no limit keeps both margins: make the slow ones slower by other data")
        return 1
    console.print(f"time_limit_s = {proposal_s}, reference_cpu_s = {reference_s}")
    if write and not only:
        text = written(PROBLEM_FILE.read_text(), proposal_s, reference_s)
        write_whole(PROBLEM_FILE, text.encode())
        load()
        console.print("problem.toml is written; the limit in problem.md is changed by hand")
    return 0


def _line(time: Time) -> str:
    least = "≥" if time.at_least else " "
    return f"{time.expected:4}{least}{time.cpu_s:6.2f} s  {time.submission}  {time.case}"


def _table(found: Margins, declared_s: float, problem: Problem) -> Table:
    asked = problem.limits.time_multipliers
    table = Table(show_edge=False)
    for heading in ("", "CPU s", "ratio", "asked", "submission", "case"):
        table.add_column(heading, overflow="fold")
    slowest, fastest = found.slowest, found.fastest
    table.add_row(
        "slowest AC",
        f"{slowest.cpu_s:.2f}",
        f"{declared_s / slowest.cpu_s:.2f}",
        f"{asked.ac_to_time_limit:.2f}",
        slowest.submission,
        slowest.case,
    )
    table.add_row("limit", f"{declared_s:.2f}")
    if fastest is not None:
        least = "≥ " if fastest.at_least else ""
        table.add_row(
            "fastest TLE",
            f"{least}{fastest.cpu_s:.2f}",
            f"{least}{fastest.cpu_s / declared_s:.2f}",
            f"{asked.time_limit_to_tle:.2f}",
            fastest.submission,
            fastest.case,
        )
    return table


if __name__ == "__main__":
    sys.exit(main())
