"""Narrower gaps: all that lies beyond a vertical or horizontal line moves towards it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain, islice, pairwise

from gen.geometry import Point, Polygon
from gen.rng import Rng
from gen.scenario import Scenario
from stress.shrinking.steps.polygons import of_polygons, polygons

MOST_GAPS = 40  # in each direction


def narrower_gaps(scenario: Scenario, _rng: Rng) -> Iterator[Scenario]:
    """Yield the scene with one gap narrowed, the displacement shortened as well or not."""
    found = polygons(scenario)
    for axis in (0, 1):
        values = sorted({vertex[axis] for vertex in chain(*found)})
        for low, high in islice(pairwise(values), MOST_GAPS):
            for by in sorted({high - low, high - low - 1, (high - low) // 2, 1} - {0}):
                closer = [_closer(polygon, axis, high, by) for polygon in found]
                for change in (0, -by, by):
                    yield of_polygons(closer, _changed(scenario.move, axis, change))


def _closer(polygon: Polygon, axis: int, beyond: int, by: int) -> Polygon:
    """Return the polygon with the vertices that are not before a line moved back."""
    return [_changed(vertex, axis, -by if vertex[axis] >= beyond else 0) for vertex in polygon]


def _changed(point: Point, axis: int, by: int) -> Point:
    x, y = point
    return (x, y + by) if axis else (x + by, y)
