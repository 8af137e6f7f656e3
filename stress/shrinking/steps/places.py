"""The scene at other places: nearer to the origin."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

from gen.geometry import Point, translated
from gen.rng import Rng
from gen.scenario import Scenario, bounds, moved
from stress.shrinking.steps.polygons import numbered, with_polygon

MOST_VERTICES = 24
NEAR = range(-2, 3)


def other_places(scenario: Scenario, _rng: Rng) -> Iterator[Scenario]:
    """Yield the whole scene moved, then one polygon moved alone."""
    for by in _ways(scenario):
        yield moved(scenario, by)
    for index, polygon in numbered(scenario):
        x, y = polygon[0]
        for dx, dy in _steps(x, y):
            yield with_polygon(scenario, index, translated(polygon, (dx, dy)))


def _ways(scenario: Scenario) -> Iterator[Point]:
    """Yield vectors that bring the box's corner, its middle or a vertex to the origin."""
    left, bottom, right, top = bounds(scenario)
    yield -left, -bottom
    yield -left, 0
    yield 0, -bottom
    yield -(left + right) // 2, -(bottom + top) // 2
    vertices = chain(scenario.robot, *scenario.obstacles[:MOST_VERTICES])
    for _, (x, y) in zip(range(MOST_VERTICES), vertices, strict=False):
        yield -x, -y
        yield -x, 0
        yield 0, -y
    for part in (2, 4, 16):
        yield -left // part, -bottom // part
        yield -right // part, -top // part
    yield from ((dx, dy) for dx in NEAR for dy in NEAR)


def _steps(x: int, y: int) -> Iterator[Point]:
    """Yield vectors towards the origin from (x, y), and short ones."""
    yield from ((dx, dy) for dx in NEAR for dy in NEAR)
    for part in (1, 2, 4, 8, 64, 1024):
        yield from ((-x // part, -y // part), (-x // part, 0), (0, -y // part))
