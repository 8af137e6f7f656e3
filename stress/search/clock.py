"""How long a search may go on: by time, or by work, which is the same on every machine."""

from __future__ import annotations

import time

from judge.problem.verdict import Verdict
from stress.search.trial import Subject

MOST_RUNS = 600
MOST_SLOW_RUNS = 40  # that go over a limit of time or memory
MOST_VERTICES = 4_000_000  # of all files of these runs: about ten seconds


class Clock:
    """Counts the seconds of a search. seconds: those it may take."""

    def __init__(self, seconds: float) -> None:
        self._start = time.perf_counter()
        self._seconds = seconds

    @property
    def is_over(self) -> bool:
        """Whether the search has to end."""
        return time.perf_counter() - self._start > self._seconds


class Budget:
    """The runs that shrinking a failure by this verdict may take.

    Counted in work and not in seconds, so that equal seeds give equal results.
    """

    def __init__(self, subject: Subject, verdict: Verdict) -> None:
        self._subject = subject
        runs = MOST_SLOW_RUNS if verdict in (Verdict.TLE, Verdict.MLE) else MOST_RUNS
        self._runs = subject.runs + runs
        self._vertices = subject.vertices + MOST_VERTICES

    @property
    def is_spent(self) -> bool:
        """Whether shrinking has to end."""
        return self._subject.runs > self._runs or self._subject.vertices > self._vertices
