"""Which of two scenarios is smaller, and which scenarios are valid."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain

from gen.geometry import Point, Polygon, is_strictly_convex
from gen.scenario import LIMIT, Scenario, bounds

# Obstacles; vertices; the largest number; the sum of all; polygons that begin elsewhere than at
# their lowest, then leftmost vertex; negative numbers; then all numbers in order.
Measure = tuple[int, int, int, int, int, int, tuple[int, ...]]


def measure(scenario: Scenario) -> Measure:
    """Return how large a scenario is. Two different scenarios never have the same measure.

    Fewer obstacles count most, then fewer vertices, then smaller coordinates (those of the
    displacement too). Below any scenario there are only finitely many, so shrinking ends.
    """
    polygons = [scenario.robot, *scenario.obstacles]
    numbers = (*scenario.move, *chain.from_iterable(chain.from_iterable(polygons)))
    sizes = list(map(abs, numbers))
    return (
        len(scenario.obstacles),
        sum(map(len, polygons)),
        max(sizes),
        sum(sizes),
        sum(not _begins_lowest(polygon) for polygon in polygons),
        sum(number < 0 for number in numbers),
        (*map(len, polygons), *numbers),
    )


def is_valid(scenario: Scenario) -> bool:
    """Tell whether a scenario keeps the constraints: strictly convex, and inside the world."""
    left, bottom, right, top = bounds(scenario)
    if min(left, bottom) < -LIMIT or max(right, top) > LIMIT:
        return False
    return all(map(is_strictly_convex, (scenario.robot, *scenario.obstacles)))


def numbers_below(scenarios: Sequence[Scenario]) -> int:
    """Return the largest |number| of some scenarios."""
    return max(measure(scenario)[2] for scenario in scenarios)


def _begins_lowest(polygon: Polygon) -> bool:
    return not polygon or polygon[0] == min(polygon, key=_height)


def _height(vertex: Point) -> Point:
    x, y = vertex
    return y, x
