"""A few random numbers changed at once: the way out where no single step makes it smaller."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain, pairwise

from gen.rng import Rng
from gen.scenario import Scenario
from stress.shrinking.steps.polygons import of_polygons, polygons

TRIES = 1_500
MOST_NUMBERS = 400  # of a scene that is worth so many tries


def changed_at_random(scenario: Scenario, rng: Rng) -> Iterator[Scenario]:
    """Yield scenes with one to four numbers changed a little, or redrawn nearer to zero."""
    numbers = [*scenario.move, *chain.from_iterable(chain(*polygons(scenario)))]
    if len(numbers) > MOST_NUMBERS:
        return
    sizes = [len(polygon) for polygon in polygons(scenario)]
    for _ in range(TRIES):
        changed = list(numbers)
        for _ in range(rng.between(1, 4)):
            at = rng.below(len(changed))
            value = changed[at]
            if rng.chance(0.6):
                changed[at] = value + rng.between(-2, 2)
            else:
                changed[at] = rng.between(-abs(value), abs(value))
        yield _scenario(changed, sizes)


def _scenario(numbers: list[int], sizes: list[int]) -> Scenario:
    points = list(zip(numbers[::2], numbers[1::2], strict=True))
    ends = [1]
    for size in sizes:
        ends.append(ends[-1] + size)
    found = [points[start:end] for start, end in pairwise(ends)]
    return of_polygons(found, points[0])
