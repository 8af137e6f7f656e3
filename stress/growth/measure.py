"""Measures on the ladders what a program's time grows with: all ladders at once, size by size."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import takewhile
from math import inf

from gen.scenario import Scenario, render
from judge.explanation import Growth
from judge.problem.verdict import Verdict
from judge.run import Attempt, Attempts
from judge.sandbox.facts import RunLimits
from stress.growth.ladders import LADDERS, Ladder, exponent
from stress.running.clock import Clock

Say = Callable[[str], None]

ELAPSED_S = 11.0  # for all ladders; a run that has begun then may end
RUN_S = 2.0  # CPU seconds of one run
STEPS = ((0.004, 8), (0.02, 4), (inf, 2))  # up to so many seconds, the next N is so many times
CLEAR_S = 0.04  # times from here on count for the fit, as start and chance matter less
NEARLY_NOTHING = [Scenario([(0, 0), (1, 0), (0, 1)], (1, 0), [])]
LEAST = 16  # no N is smaller
FITTED = 3  # points, the largest
LEAST_RATIO = 3.0  # of the longest time to the shortest in a fit
MARGIN = 0.4  # an exponent so far above what it may be is no logarithm and no chance
ALIKE = 0.25  # exponents that differ by less are equal: the simpler ladder is told first


def measure(
    attempts: Attempts,
    limits: RunLimits,
    say: Say = lambda _text: None,
    ladders: Sequence[Ladder] = LADDERS,
) -> tuple[Growth, ...]:
    """Return how a program's CPU time grows on each ladder, what to tell first at the beginning.

    attempts: runs it on texts of input files, several at once. limits: those of its judging.
    Takes at most about 15 seconds. Raises KitError.
    """
    seconds = min(limits.time_limit_s, RUN_S)
    shorter = limits._replace(time_limit_s=seconds, elapsed_s=2 * seconds + 1)
    clock = Clock(ELAPSED_S)
    say("measuring what its time grows with")
    starts = attempts([render(NEARLY_NOTHING)] * 3, shorter)
    start_s = min(attempt.facts.cpu_s for attempt in starts)
    climbs = [_Climb(ladder, start_s, seconds) for ladder in ladders]
    while not clock.is_over and (climbing := [climb for climb in climbs if climb.goes_on]):
        largest = max(climb.size for climb in climbing)
        say(f"measuring what its time grows with: N up to {largest:,}")
        started = list[_Climb]()

        def contents(climbing: Sequence[_Climb], started: list[_Climb]) -> Iterator[bytes]:
            for climb in takewhile(lambda _climb: not clock.is_over, climbing):
                started.append(climb)
                yield render(climb.ladder.make(climb.size))

        for index, attempt in enumerate(attempts(contents(climbing, started), shorter)):
            started[index].note(attempt)
    growths = {climb.ladder.name: climb.growth() for climb in climbs}
    fast = {name for name, growth in growths.items() if growth.too_fast}
    return in_order([growths[ladder.name] for ladder in ladders if ladder.harder_than not in fast])


class _Climb:
    """One ladder, climbed until a run takes too long or the largest size is done.

    If too few times are clear then, smaller sizes are measured. start_s: what the program takes
    for nearly nothing. most_s: the time limit of a run.
    """

    def __init__(self, ladder: Ladder, start_s: float, most_s: float) -> None:
        self.ladder = ladder
        self.size = ladder.least
        self.goes_on = True
        self._clear_s = CLEAR_S + start_s / 2
        self._start_s = start_s
        self._most_s = most_s
        self._cpu_s: dict[int, float] = {}  # by size
        self._over: int | None = None  # the smallest size that took too long

    def note(self, attempt: Attempt) -> None:
        """Note the run on the current size, and choose the next one."""
        verdict = attempt.judgement.verdict
        if verdict is Verdict.TLE:
            self._over = self.size
        elif verdict is Verdict.AC:
            self._cpu_s[self.size] = round(max(attempt.facts.cpu_s - self._start_s, 0.0001), 4)
        following = self._following() if verdict in (Verdict.AC, Verdict.TLE) else None
        self.goes_on = following is not None
        self.size = following or self.size

    def _following(self) -> int | None:
        """Return the next size, None if the climb is over."""
        clear = [size for size, seconds in self._cpu_s.items() if seconds >= self._clear_s]
        if self._over is None:
            largest = max(self._cpu_s)
            factor = next(factor for most_s, factor in STEPS if self._cpu_s[largest] <= most_s)
            following = min(factor * largest, self.ladder.most)
            if following > largest and self._expected_s(following) <= self._most_s:
                return following
        if len(clear) >= FITTED:
            return None
        slow = [*clear, *([] if self._over is None else [self._over])]
        half = min(slow, default=0) // 2
        return half if half >= LEAST and half not in self._cpu_s else None

    def _expected_s(self, size: int) -> float:
        """Return how long a larger size takes if the time goes on growing as it does."""
        sizes = sorted(self._cpu_s)[-2:]
        last_s = self._cpu_s[sizes[-1]]
        if len(sizes) < 2 or last_s < CLEAR_S:
            return 0.0
        growth = exponent(sizes, [self._cpu_s[size] for size in sizes])
        factor: float = (size / sizes[-1]) ** max(growth, 0.0)
        return last_s * factor

    def growth(self) -> Growth:
        """Return what was measured."""
        points = sorted(self._cpu_s.items())
        clear = [point for point in points if point[1] >= self._clear_s][-FITTED:]
        sizes, cpu_s = zip(*(clear or points[-1:]), strict=True) if points else ((), ())
        found = exponent(sizes, cpu_s) if clear and sizes[-1] >= 2 * sizes[0] else None
        rises = bool(cpu_s) and cpu_s[-1] >= LEAST_RATIO * cpu_s[0]
        return Growth(
            ladder=self.ladder.name,
            quantity=self.ladder.quantity,
            sizes=sizes,
            cpu_s=cpu_s,
            over=self._over,
            exponent=found,
            may=self.ladder.may,
            too_fast=found is not None and rises and found > self.ladder.may + MARGIN,
        )


def in_order(growths: Sequence[Growth]) -> tuple[Growth, ...]:
    """Return those that grow too fast first, the fastest of them at the beginning. Pure.

    Of exponents that are about alike, the one of the simpler ladder comes first.
    """
    left, ordered = list(growths), list[Growth]()
    while fast := [growth for growth in left if growth.too_fast]:
        most = max(_excess(growth) for growth in fast)
        chosen = next(growth for growth in fast if _excess(growth) >= most - ALIKE)
        ordered.append(chosen)
        left.remove(chosen)
    return (*ordered, *left)


def _excess(growth: Growth) -> float:
    return (growth.exponent or 0.0) - growth.may
