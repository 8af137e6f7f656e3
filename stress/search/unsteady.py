"""Programs that answer one input in several ways: what can still be said honestly."""

from __future__ import annotations

from dataclasses import dataclass

from stress.running.trial import Subject, Trial
from stress.shrinking.measure import measure
from stress.shrinking.sequence import SIMPLE

RUNS = 10
CANDIDATES = 4
LEAST_FAILURES = 2


@dataclass(frozen=True, slots=True)
class Unsteady:
    """A scenario that fails in some of its runs. failures: in how many of `runs`."""

    trial: Trial
    failures: int
    runs: int


def unsteady(subject: Subject, failed: Trial) -> Unsteady | None:
    """Return a small scenario that fails at least twice alone; None if none is found."""
    wrong = sorted((failed.scenarios[index] for index in failed.wrong), key=measure)
    for scenario in (*SIMPLE, *wrong[:CANDIDATES], *failed.scenarios[-1:]):
        trials = list(subject.trials([[scenario]] * RUNS))
        failures = [trial for trial in trials if trial.failed]
        if len(failures) >= LEAST_FAILURES:
            return Unsteady(failures[0], len(failures), RUNS)
    return None
