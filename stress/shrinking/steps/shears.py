"""Shears (x, y) -> (x + s * y, y): they change no answer, and make slim scenes compact."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from gen.geometry import Point, Polygon, minus
from gen.rng import Rng
from gen.scenario import Scenario
from stress.shrinking.steps.polygons import of_polygons, polygons

FACTORS = (-5, -4, -3, -2, -1, 1, 2, 3, 4, 5)
MOST_EDGES = 40


def sheared(scenario: Scenario, _rng: Rng) -> Iterator[Scenario]:
    """Yield the scene sheared, above all so that some edge, or the move, becomes upright."""
    found = polygons(scenario)
    first_x, first_y = scenario.robot[0]
    edges = [minus(b, a) for polygon in found for a, b in pairwise(polygon)][:MOST_EDGES]
    factors_x, factors_y = set(FACTORS), set(FACTORS)
    for x, y in [scenario.move, *edges]:
        if y:
            factors_x |= {-x // y, 1 - x // y - 1, -(x // y)}
        if x:
            factors_y |= {-y // x, 1 - y // x - 1, -(y // x)}
    for s in sorted(factors_x - {0}):
        yield _sheared(found, scenario.move, s, 0, (first_x, first_y))
    for s in sorted(factors_y - {0}):
        yield _sheared(found, scenario.move, 0, s, (first_x, first_y))


def _sheared(found: list[Polygon], move: Point, s: int, t: int, fixed: Point) -> Scenario:
    """Return (x, y) -> (x + s * y, y + t * x), one of s and t zero, about a fixed point."""
    fixed_x, fixed_y = fixed
    dx, dy = move
    return of_polygons(
        [[(x + s * (y - fixed_y), y + t * (x - fixed_x)) for x, y in p] for p in found],
        (dx + s * dy, dy + t * dx),
    )
