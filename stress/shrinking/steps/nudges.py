"""One vertex elsewhere: a little, halfway to zero, at zero, or at round numbers."""

from __future__ import annotations

from collections.abc import Iterator

from gen.geometry import Point
from gen.rng import Rng
from gen.scenario import Scenario
from stress.shrinking.steps.polygons import numbered, with_polygon

MOST_VERTICES = 40  # of one polygon
NEAR = range(-3, 4)


def nudged(scenario: Scenario, _rng: Rng) -> Iterator[Scenario]:
    """Yield the scene with one vertex at another place."""
    for index, polygon in numbered(scenario):
        for at, vertex in enumerate(polygon[:MOST_VERTICES]):
            for other in _others(vertex):
                changed = list(polygon)
                changed[at] = other
                yield with_polygon(scenario, index, changed)


def _others(vertex: Point) -> Iterator[Point]:
    x, y = vertex
    yield from ((x + dx, y + dy) for dx in NEAR for dy in NEAR if dx or dy)
    for part in (1, 2, 4, 8, 16, 64, 1024, 16384):
        nearer_x, nearer_y = x - _part(x, part), y - _part(y, part)
        yield from ((nearer_x, y), (x, nearer_y), (nearer_x, nearer_y))
    for digits in (1, 2, 3):
        round_x, round_y = _rounded(x, digits), _rounded(y, digits)
        yield from ((round_x, y), (x, round_y), (round_x, round_y))


def _rounded(value: int, digits: int) -> int:
    """Return a value near to it, towards zero, with so many digits before its zeros."""
    unit: int = 10 ** max(0, len(str(abs(value))) - digits)
    return _part(value, unit) * unit


def _part(value: int, part: int) -> int:
    """Return value / part, rounded towards zero."""
    return value // part if value >= 0 else -(-value // part)
