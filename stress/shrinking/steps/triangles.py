"""Polygons replaced by their boxes, and by triangles: small ones, or as wide as they are."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from gen.geometry import Point, Polygon, hull
from gen.rng import Rng
from gen.scenario import Scenario
from stress.shrinking.steps.polygons import numbered, with_polygon

MOST_VERTICES = 12  # of polygons at whose every vertex a triangle is tried
UNITS = ((1, 0), (0, 1), (-1, 0), (0, -1))


def replaced_by_triangles(scenario: Scenario, _rng: Rng) -> Iterator[Scenario]:
    """Yield the scenario with one polygon replaced."""
    for index, polygon in numbered(scenario):
        for simple in (*_corner_triangles(polygon), *_box_triangles(polygon)):
            yield with_polygon(scenario, index, simple)


def _corner_triangles(polygon: Polygon) -> Iterator[Polygon]:
    """Yield the smallest triangles that have a vertex in common with the polygon."""
    for x, y in polygon[:MOST_VERTICES]:
        for (ax, ay), (bx, by) in combinations(UNITS, 2):
            yield hull([(x, y), (x + ax, y + ay), (x + bx, y + by)])


def _box_triangles(polygon: Polygon) -> Iterator[Polygon]:
    """Yield the bounding box, its triangles, and those of a vertex and two corners of it."""
    xs, ys = zip(*polygon, strict=True)
    left, right, bottom, top = min(xs), max(xs), min(ys), max(ys)
    corners: list[Point] = [(left, bottom), (right, bottom), (right, top), (left, top)]
    yield corners
    for pair in combinations(corners, 2):
        for third in (*corners, *polygon[:MOST_VERTICES]):
            yield hull([*pair, third])
