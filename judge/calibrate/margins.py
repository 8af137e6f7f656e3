"""The margins of the time limit: between the slowest accepted and the fastest slow submission.

Every submission declared AC or TLE in a group is timed there. The limit must be
`ac_to_time_limit` times the slowest accepted run, and the fastest slow submission must
take `time_limit_to_tle` times the limit (the time multipliers of the Kattis problem
package format). A slow submission is stopped at BOUND_FACTOR times that, and is not run on
further cases of the group: its time is then "at least" so long.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from judge.judging import JudgeError
from judge.kit.paths import SUBMISSIONS
from judge.languages.submission import compile_submission, read_submission
from judge.problem.cases import Case
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from judge.run import declared_limits, run_case
from judge.sandbox.sandbox import Sandbox

BOUND_FACTOR = 2.0
STEP_S = 0.5  # limits are multiples of this


@dataclass(frozen=True, slots=True)
class Time:
    """The slowest run of a submission in a group. at_least: it was stopped at `cpu_s`."""

    submission: str
    group: str
    expected: Verdict
    case: str
    cpu_s: float
    at_least: bool


@dataclass(frozen=True, slots=True)
class Margins:
    """The limit must lie between `least_s`, set by `slowest`, and `most_s`, set by `fastest`."""

    slowest: Time
    fastest: Time | None
    least_s: float
    most_s: float

    def fits(self, limit_s: float) -> bool:
        """Tell whether this limit keeps both margins."""
        return self.least_s <= limit_s <= self.most_s

    def proposal(self, declared_s: float) -> float | None:
        """Return the declared limit if it fits, else the least multiple of STEP_S, or None."""
        rounded_s = math.ceil(self.least_s / STEP_S) * STEP_S
        return next((s for s in (declared_s, rounded_s) if self.fits(s)), None)


def margins(times: Sequence[Time], problem: Problem) -> Margins:
    """Return the margins that follow from `times`. Raises JudgeError if none is of an AC."""
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
    limits = declared_limits(problem.limits, over_s * BOUND_FACTOR)
    times = []
    for group in problem.group_names:
        expected = problem.expected(name, group)
        own = [case for case in cases if case.group == group]
        if not own or expected not in ({Verdict.AC}, {Verdict.TLE}):
            continue
        runs = []
        for case in sorted(own, key=_size, reverse=True):  # large inputs reveal slowness
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
