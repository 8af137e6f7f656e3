"""Shrinks one scenario that fails alone, until no step makes it smaller."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from gen.rng import Rng
from gen.scenario import Scenario
from judge.kit.text import counted
from judge.problem.verdict import Verdict
from stress.running.clock import Budget
from stress.running.trial import Subject, Trial, shortest_failing_prefix
from stress.shrinking.measure import measure, numbers_of
from stress.shrinking.steps import smaller

FIRST_FILE, GROWTH = 1, 8  # of a program that does not answer a whole file
MOST_REJECTED = 6


class UnsteadyError(Exception):
    """The program answers the same input differently from run to run."""


@dataclass(frozen=True, slots=True)
class Shrunk:
    """The smallest failing file that was found. complete: no step makes it smaller."""

    trial: Trial
    complete: bool


def shrink(
    subject: Subject,
    start: Trial,
    rng: Rng,
    budget: Budget,
    say: Callable[[str], None] = lambda _text: None,
) -> Shrunk:
    """Return the smallest scenario that fails alone as `start` does, by the same verdict.

    start: the trial of a file of one scenario. Each round tries many smaller scenarios in one
    run, then the smallest that fails there alone; so a program that keeps something between
    scenarios misleads only for a round. Raises UnsteadyError.
    """
    best, rejected = start, set[tuple[int, ...]]()
    while not budget.is_spent and len(rejected) < MOST_REJECTED:
        (scenario,) = best.scenarios
        size = measure(scenario)
        say(f"shrinking: {counted(size[0], 'obstacle')}, {size[1]} vertices, up to {size[2]}")
        found = _next(subject, scenario, best.verdict, rng, budget, rejected)
        if found is None:
            _fails_again(subject, best)
            return Shrunk(best, not budget.is_spent)
        trial = subject.trial([found])
        if trial.verdict is best.verdict:
            best = trial
            continue
        rejected.add(numbers_of(found))
        _fails_again(subject, best)
    return Shrunk(best, complete=False)


def _fails_again(subject: Subject, best: Trial) -> None:
    """Raise UnsteadyError unless what failed before still does."""
    if subject.trial(best.scenarios).verdict is not best.verdict:
        raise UnsteadyError


def _next(
    subject: Subject,
    scenario: Scenario,
    verdict: Verdict,
    rng: Rng,
    budget: Budget,
    rejected: set[tuple[int, ...]],
) -> Scenario | None:
    """Return a smaller scenario that fails among others; None if there is none."""
    for batch in smaller(scenario, rng):
        candidates = [each for each in batch if numbers_of(each) not in rejected]
        found = first_failing(subject, candidates, verdict)
        if found is not None or budget.is_spent:
            return found
    return None


def first_failing(
    subject: Subject, candidates: list[Scenario], verdict: Verdict
) -> Scenario | None:
    """Return the first of some scenarios that the program fails on with this verdict.

    One run, if the program answers them all. If not, the first file that it does not answer
    is cut at the scenario that makes it fail, by bisection.
    """
    if verdict is Verdict.WA:
        trial = subject.trial(candidates)
        if not trial.failed:
            return None
        if trial.in_step:
            return candidates[trial.wrong[0]]
    for file in _growing(candidates):
        while file:
            shortest = shortest_failing_prefix(subject, file)
            if shortest is None:
                break
            if shortest.verdict is verdict:
                return shortest.scenarios[-1]
            file = file[len(shortest.scenarios) :]
    return None


def _growing(candidates: list[Scenario]) -> Iterator[list[Scenario]]:
    """Yield the candidates in files that become larger."""
    start, size = 0, FIRST_FILE
    while start < len(candidates):
        yield candidates[start : start + size]
        start, size = start + size, size * GROWTH
