"""Fewer vertices: any three or more vertices of a convex polygon are a convex polygon."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product

from gen.geometry import Polygon
from gen.rng import Rng
from gen.scenario import Scenario
from stress.shrinking.steps.parts import parts
from stress.shrinking.steps.polygons import numbered, of_polygons, polygons, with_polygon

MOST_FOR_ALL_TRIANGLES = 9
MOST_PAIRS = 400


def fewer_vertices(scenario: Scenario, _rng: Rng) -> Iterator[Scenario]:
    """Yield the scenario with fewer vertices of one polygon, then of all polygons at once."""
    for index, polygon in numbered(scenario):
        for fewer in _fewer(polygon):
            yield with_polygon(scenario, index, fewer)
    found = polygons(scenario)
    if len(found) == 2:
        choices = [[polygon, *_triangles(polygon)] for polygon in found]
        if len(choices[0]) * len(choices[1]) <= MOST_PAIRS:
            for both in product(*choices):
                yield of_polygons(list(both), scenario.move)
    if max(map(len, found)) > MOST_FOR_ALL_TRIANGLES:
        for step in (2, 3, 10, 30):
            thin = [p[:: min(step, len(p) // 3)] for p in found]
            yield of_polygons(thin, scenario.move)


def _fewer(polygon: Polygon) -> Iterator[Polygon]:
    n = len(polygon)
    for kept in parts(n, least=3):
        yield [polygon[i] for i in kept]
    if n > 4:
        yield polygon[::2]
    yield from _triangles(polygon)


def _triangles(polygon: Polygon) -> Iterator[Polygon]:
    """Yield every triangle of a small polygon; of a larger one, some that are as wide as it."""
    n = len(polygon)
    if 3 < n <= MOST_FOR_ALL_TRIANGLES:
        yield from map(list, combinations(polygon, 3))
    elif n > 3:
        for first in range(0, n, max(1, n // 8)):
            ordered = sorted((first + n * third // 3) % n for third in range(3))
            yield [polygon[i] for i in ordered]
            yield [polygon[i] for i in sorted((first, (first + 1) % n, (first + 2) % n))]
