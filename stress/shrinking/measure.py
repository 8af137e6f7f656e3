"""Which of two scenarios is smaller, and which scenarios are valid."""

from __future__ import annotations

from itertools import chain

from gen.geometry import Point, Polygon, is_strictly_convex
from gen.scenario import LIMIT, Scenario, bounds

# Obstacles; vertices; the largest number; the sum of all; their significant digits; polygons that
# begin elsewhere than at their lowest, then leftmost vertex; negative numbers; the numbers.
Measure = tuple[int, int, int, int, int, int, int, tuple[int, ...]]

EXACT = 64  # numbers below this are compared exactly
BITS = 5  # of larger ones


def measure(scenario: Scenario) -> Measure:
    """Return how large a scenario is.

    Fewer obstacles count most, then fewer vertices, then smaller and rounder numbers (those of
    the displacement too). Large numbers count only roughly, so that shrinking them ends soon;
    two scenarios of small numbers never have the same measure.
    """
    polygons = [scenario.robot, *scenario.obstacles]
    numbers = numbers_of(scenario)
    sizes = list(map(abs, numbers))
    largest = max(sizes)
    return (
        len(scenario.obstacles),
        sum(map(len, polygons)),
        _rough(largest),
        _rough(sum(sizes)),
        sum(len(str(size).rstrip("0")) for size in sizes) if largest >= EXACT else 0,
        sum(not _begins_lowest(polygon) for polygon in polygons),
        sum(number < 0 for number in numbers),
        (*map(len, polygons), *numbers) if largest < EXACT else (),
    )


def numbers_of(scenario: Scenario) -> tuple[int, ...]:
    """Return the displacement and all coordinates, as they stand in the file."""
    polygons = (scenario.robot, *scenario.obstacles)
    return (*scenario.move, *chain.from_iterable(chain.from_iterable(polygons)))


def _rough(number: int) -> int:
    """Return a number with all but its highest bits cleared."""
    dropped = max(0, number.bit_length() - BITS) if number >= EXACT else 0
    return number >> dropped << dropped


def is_valid(scenario: Scenario) -> bool:
    """Tell whether a scenario keeps the constraints: strictly convex, and inside the world."""
    left, bottom, right, top = bounds(scenario)
    if min(left, bottom) < -LIMIT or max(right, top) > LIMIT:
        return False
    return all(map(is_strictly_convex, (scenario.robot, *scenario.obstacles)))


def _begins_lowest(polygon: Polygon) -> bool:
    return not polygon or polygon[0] == min(polygon, key=_height)


def _height(vertex: Point) -> Point:
    x, y = vertex
    return y, x
