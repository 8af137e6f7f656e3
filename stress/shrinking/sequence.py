"""Shrinks a file of several scenarios, none of which fails alone."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import chain, product

from gen.rng import Rng
from gen.scenario import Scenario
from judge.problem.verdict import Verdict
from stress.running.clock import Budget
from stress.running.trial import Subject, Trial
from stress.shrinking.measure import measure
from stress.shrinking.single import Shrunk
from stress.shrinking.steps import smaller
from stress.shrinking.steps.parts import parts

MOST_RUNS = 150  # for one scenario in one round: each candidate is a run of its own

UNIT = [(0, 0), (1, 0), (0, 1)]
SIMPLE = (  # no obstacle; a collision; a free robot
    Scenario(UNIT, (0, 0), []),
    Scenario(UNIT, (0, 0), [UNIT]),
    Scenario(UNIT, (0, 0), [[(2, 0), (3, 0), (2, 1)]]),
    Scenario(UNIT, (1, 0), []),
    Scenario(UNIT, (1, 0), [UNIT]),
    Scenario(UNIT, (1, 0), [[(3, 0), (4, 0), (3, 1)]]),
)


def shrink_sequence(
    subject: Subject,
    start: Trial,
    rng: Rng,
    budget: Budget,
    say: Callable[[str], None] = lambda _text: None,
) -> Shrunk:
    """Return a short sequence of small scenarios that fails as `start` does.

    First scenarios are dropped, then each is replaced by a simpler one. Every candidate is a run
    of its own, so that nothing is left over from another one.
    """
    best, changed = start, True
    while changed and not budget.is_spent:
        say(f"shrinking: a sequence of {len(best.scenarios)} scenarios")
        changed = False
        shorter = _first(subject, _shorter(best.scenarios), best.verdict)
        if shorter is not None:
            best, changed = shorter, True
            continue
        for place in range(len(best.scenarios)):
            simpler = _first(subject, _simpler(best.scenarios, place, rng), best.verdict)
            if budget.is_spent:
                break
            if simpler is not None:
                best, changed = simpler, True
                break
    return Shrunk(best, not budget.is_spent)


def _first(
    subject: Subject, sequences: Iterable[Sequence[Scenario]], verdict: Verdict
) -> Trial | None:
    """Return the trial of the first failing sequence, up to its first wrong answer."""
    failed = subject.first_failure(sequences, verdict)
    if failed is None or not failed.wrong or failed.wrong[0] + 1 == len(failed.scenarios):
        return failed
    cut = subject.trial(failed.scenarios[: failed.wrong[0] + 1])
    return cut if cut.verdict is verdict else failed


def _shorter(scenarios: Sequence[Scenario]) -> Iterator[list[Scenario]]:
    """Yield shorter sequences: of simple scenarios; each with the last; parts of all."""
    if len(scenarios) > 1:
        yield from ([one] for one in SIMPLE)
    if len(scenarios) > 2:
        yield from map(list, product(SIMPLE, repeat=2))
        for index in range(len(scenarios) - 2, max(-1, len(scenarios) - 8), -1):
            yield [scenarios[index], scenarios[-1]]
    for kept in sorted(parts(len(scenarios) - 1), key=len):
        yield [*(scenarios[index] for index in kept), scenarios[-1]]
    for kept in sorted(parts(len(scenarios)), key=len):
        yield [scenarios[index] for index in kept]


def _simpler(scenarios: Sequence[Scenario], place: int, rng: Rng) -> Iterator[list[Scenario]]:
    """Yield the sequence with one scenario replaced by simpler ones."""
    size = measure(scenarios[place])
    simple = [one for one in SIMPLE if measure(one) < size]
    others = list(chain.from_iterable(smaller(scenarios[place], rng)))
    spread = others[:: max(1, len(others) // MOST_RUNS)]
    for one in chain(simple, spread):
        yield [*scenarios[:place], one, *scenarios[place + 1 :]]
