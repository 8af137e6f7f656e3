"""The results of a judging: of each case, of each group and of the whole."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from judge.compare import Mismatch
from judge.explanation import Counterexample, Diagnosis, Slowness
from judge.problem.cases import Case
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict

NOT_RUN = "not run"


@dataclass(frozen=True, slots=True)
class Scale:
    """How many times slower this machine is than the calibrating one, at least 1.

    source: a short text for the user that says where the figure comes from.
    """

    factor: float
    source: str


@dataclass(frozen=True, slots=True)
class CaseResult:
    """The result of one test case; verdict None: it was not run (`message` says why).

    mismatch: for WA, the first difference. retried: it was over the declared
    time limit, and was repeated under that of this machine, which is slower; first_verdict: of
    the first of these two runs, if it differs. stderr: what is kept of the standard error of a
    program that is not accepted, as printable lines. withheld: the case's files and its
    message may not be told; `case.name` is then only a number in its group.
    """

    case: Case
    verdict: Verdict | None
    cpu_s: float
    elapsed_s: float
    memory_mib: float
    message: str = ""
    retried: bool = False
    first_verdict: Verdict | None = None
    mismatch: Mismatch | None = None
    stderr: str = ""
    withheld: bool = False


@dataclass(frozen=True, slots=True)
class GroupResult:
    """The result of a group, which scores all or nothing. whole: all of its cases were chosen."""

    name: str
    verdict: Verdict
    score: int
    max_score: int
    whole: bool
    cases: tuple[CaseResult, ...]

    @property
    def slowest(self) -> CaseResult | None:
        """The case with the most CPU time among those that ran."""
        ran = [result for result in self.cases if result.verdict is not None]
        return max(ran, key=lambda result: result.cpu_s, default=None)


@dataclass(frozen=True, slots=True)
class Judging:
    """All runs of one submission, in the order of judging.

    time_limit_s: the limit that held; declared_s: the one of problem.toml; scale: how many
    times slower than the calibrating machine this one is, and where that figure comes from,
    None if it was not needed. partial: the cases are not all of the kit's, so the score says
    less. message: the compiler's, for CE. wall: the wall around every run, or None.
    limit_given: the time limit is not the declared one, scaled or not. diagnosis: for a program
    that ran and is not accepted, if feedback permits it; counterexample: if one was asked for,
    permitted and found; unexplained: if one was asked for and not found, why. slowness: of a
    program that was too slow for a case, if feedback permits it.
    """

    submission: str
    language: str
    verdict: Verdict
    score: int
    max_score: int
    partial: bool
    time_limit_s: float
    declared_s: float
    memory_mib: int
    scale: Scale | None
    groups: tuple[GroupResult, ...]
    message: str = ""
    wall: str | None = None
    limit_given: bool = False
    diagnosis: Diagnosis | None = None
    counterexample: Counterexample | None = None
    unexplained: str = ""
    slowness: Slowness | None = None

    @property
    def cases(self) -> tuple[CaseResult, ...]:
        """The results of all cases in order."""
        return tuple(result for group in self.groups for result in group.cases)

    @property
    def changed(self) -> tuple[CaseResult, ...]:
        """The results whose verdict changed when the run was repeated."""
        return tuple(result for result in self.cases if result.first_verdict is not None)

    @property
    def first_failure(self) -> CaseResult | None:
        """The first case in order that was run and not accepted."""
        failures = (r for r in self.cases if r.verdict not in (None, Verdict.AC))
        return next(failures, None)


def not_run(case: Case, why: str) -> CaseResult:
    """Return the result of a case that was not run."""
    return CaseResult(case, None, 0.0, 0.0, 0.0, f"{NOT_RUN}: {why}")


def first_failure(verdicts: Iterable[Verdict | None]) -> Verdict:
    """Return the first verdict that is neither AC nor missing; AC if there is none."""
    return next((v for v in verdicts if v not in (None, Verdict.AC)), Verdict.AC)


def group_results(
    problem: Problem, all_cases: Sequence[Case], results: Sequence[CaseResult]
) -> tuple[GroupResult, ...]:
    """Gather results, in order, into groups. A group scores if all of its cases are AC."""
    points = {group.name: group.points for group in problem.groups}
    groups = []
    for name in dict.fromkeys(result.case.group for result in results):
        own = tuple(result for result in results if result.case.group == name)
        whole = len(own) == sum(case.group == name for case in all_cases)
        solved = whole and all(result.verdict is Verdict.AC for result in own)
        worth = points.get(name, 0)
        verdict = first_failure(result.verdict for result in own)
        groups.append(GroupResult(name, verdict, worth if solved else 0, worth, whole, own))
    return tuple(groups)
