"""The whole search: find a file that fails, the culprit in it, and shrink that."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain

from gen.rng import Rng
from judge.explanation import Counterexample
from judge.problem.verdict import Verdict
from judge.results import CaseResult
from stress.search.clock import Budget, Clock
from stress.search.find import culprit
from stress.search.result import counterexample
from stress.search.sequence import shrink_sequence
from stress.search.shrink import Shrunk, UnsteadyError, shrink
from stress.search.slow import slow_when_small
from stress.search.start import given, larger, tiny
from stress.search.trial import Subject, Trial
from stress.search.unsteady import unsteady

Say = Callable[[str], None]

DRAWING_S = 20.0  # for drawing scenarios until one fails
TLE_PART = 5  # a candidate is slow if it takes more than this part of the time limit

OF_SIZE = (Verdict.TLE, Verdict.MLE)  # verdicts that a large input alone may bring about
NOTHING_FAILS = "no scenario was found that it fails on"
ONLY_SIZE = (
    "no small input makes it exceed a limit, and all small ones that were tried were answered "
    "correctly: it needs too much time or memory for large ones"
)
ONLY_LIMIT = "it is slow on the smallest input that was found, but not beyond the time limit"
CHANGES = "its answers to the same input change from run to run"
DEPENDS = "its answer to a scenario depends on the scenarios before it"
DEPENDS_ON_FILE = "its answer to a scenario depends on the other scenarios of the file"


@dataclass(frozen=True, slots=True)
class Result:
    """What a search found.

    failed: the program failed on something. remark: why there is no counterexample. answered:
    how many scenarios were answered correctly.
    """

    counterexample: Counterexample | None
    failed: bool
    remark: str
    answered: int


def search(
    subject: Subject,
    failures: Sequence[CaseResult],
    *,
    seed: int,
    drawing_s: float = DRAWING_S,
    say: Say = lambda _text: None,
) -> Result:
    """Search for a smallest counterexample. Equal seeds, equal results, if time suffices.

    failures: test cases that the program is known to fail on, if any. drawing_s: how many
    seconds to draw scenarios. Raises KitError.
    """
    began = time.perf_counter()
    say("searching for a small counterexample")
    only_size = bool(failures) and all(case.verdict in OF_SIZE for case in failures)
    for failed in _failing(subject, failures, seed, Clock(drawing_s), say, only_size=only_size):
        found = _shrunk(subject, failed, seed, began, say)
        if isinstance(found, Counterexample):
            return Result(found, True, "", subject.answered)
        return Result(None, True, found, subject.answered)
    return Result(None, only_size, ONLY_SIZE if only_size else NOTHING_FAILS, subject.answered)


def _failing(
    subject: Subject,
    failures: Sequence[CaseResult],
    seed: int,
    clock: Clock,
    say: Say,
    *,
    only_size: bool,
) -> Iterator[Trial]:
    """Yield trials that failed, those of the smallest scenarios first."""
    if only_size:
        return chain(tiny(subject, seed), slow_when_small(_hurried(subject), failures))
    return chain(tiny(subject, seed), given(subject, failures), larger(subject, seed, clock, say))


def _shrunk(
    subject: Subject, failed: Trial, seed: int, began: float, say: Say
) -> Counterexample | str:
    """Return the counterexample that a failing file shrinks to; or why there is none."""
    user = _hurried(subject) if failed.verdict is Verdict.TLE else subject
    steps = [f"seed {seed}"]
    try:
        say("looking for the scenario that fails")
        start = culprit(user, failed)
        shrunk = _smallest(user, start, seed, say)
    except UnsteadyError:
        chancy = unsteady(user, failed)
        if chancy is None:
            return CHANGES
        steps.append(CHANGES)
        found = f"{chancy.trial.found} (in {chancy.failures} of {chancy.runs} runs)"
        return counterexample(chancy.trial, found, time.perf_counter() - began, tuple(steps))
    trial = shrunk.trial
    if trial.verdict is Verdict.TLE:
        say("running it with the whole time limit")
        trial = subject.trial(trial.scenarios)
        if trial.verdict is not Verdict.TLE:
            return ONLY_LIMIT
    if len(trial.scenarios) > 1:
        last_fails = trial.index == len(trial.scenarios) - 1
        steps.append(DEPENDS if last_fails else DEPENDS_ON_FILE)
    if not shrunk.complete:
        steps.append("the search was ended: there may be a smaller one")
    return counterexample(trial, trial.found, time.perf_counter() - began, tuple(steps))


def _smallest(subject: Subject, start: Trial, seed: int, say: Say) -> Shrunk:
    """Shrink a failing file; a sequence that fails by its last scenario alone as that one."""
    budget = Budget(subject, start.verdict)
    if len(start.scenarios) > 1:
        shrunk = shrink_sequence(subject, start, Rng(seed), budget, say)
        if len(shrunk.trial.scenarios) > 1:
            return shrunk
        start = shrunk.trial
    return shrink(subject, start, Rng(seed), budget, say)


def _hurried(subject: Subject) -> Subject:
    """Return the same program with less time, which is still many times what is needed."""
    limits = subject.limits
    hurried = limits.time_limit_s / TLE_PART
    return subject.limited(limits._replace(time_limit_s=hurried, elapsed_s=3 * hurried))
