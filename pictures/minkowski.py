"""The Minkowski sum of two convex polygons, each edge with the polygon that it comes from."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import IntEnum
from math import atan2, pi

from gen.geometry import Point, Polygon, cross, is_upper, minus


class Source(IntEnum):
    """Where an edge of a sum comes from."""

    FIRST = 0
    SECOND = 1
    BOTH = 2  # two edges of one direction, one behind the other


@dataclass(frozen=True, slots=True)
class Edge:
    """An edge of a sum: where it begins, how far it goes, and where it comes from.

    joint: where the first polygon's part ends and the second's begins, if it comes from BOTH.
    """

    start: Point
    way: Point
    source: Source
    joint: Point | None = None

    @property
    def end(self) -> Point:
        """Where the edge ends."""
        return self.start[0] + self.way[0], self.start[1] + self.way[1]

    def parts(self) -> list[tuple[Source, list[Point]]]:
        """Return the parts, each from one polygon, as lines [start, end]."""
        if self.joint is None:
            return [(self.source, [self.start, self.end])]
        return [
            (Source.FIRST, [self.start, self.joint]),
            (Source.SECOND, [self.joint, self.end]),
        ]


def ways(polygon: Polygon) -> list[Point]:
    """Return the edges as vectors, from the lowest, then leftmost, vertex on."""
    turned = from_lowest(polygon)
    return [minus(b, a) for a, b in zip(turned, turned[1:] + turned[:1], strict=True)]


def from_lowest(polygon: Polygon) -> Polygon:
    """Return the polygon from its lowest, then leftmost, vertex on."""
    at = min(range(len(polygon)), key=lambda i: (polygon[i][1], polygon[i][0]))
    return polygon[at:] + polygon[:at]


def merged(first: Polygon, second: Polygon) -> Iterator[Edge]:
    """Yield the edges of the sum, counter-clockwise, from its lowest, then leftmost, vertex on.

    first, second: strictly convex, counter-clockwise. Exact; O(n + m).
    Source: de Berg et al., Computational Geometry (3rd ed.), 13.3.
    """
    ours, theirs = ways(first), ways(second)
    (ax, ay), (bx, by) = from_lowest(first)[0], from_lowest(second)[0]
    x, y = ax + bx, ay + by
    i = j = 0
    while i < len(ours) or j < len(theirs):
        turn = _turn(ours, i, theirs, j)
        if turn > 0:
            edge = Edge((x, y), ours[i], Source.FIRST)
        elif turn < 0:
            edge = Edge((x, y), theirs[j], Source.SECOND)
        else:
            (ux, uy), (vx, vy) = ours[i], theirs[j]
            edge = Edge((x, y), (ux + vx, uy + vy), Source.BOTH, (x + ux, y + uy))
        yield edge
        i, j = i + (turn >= 0), j + (turn <= 0)
        x, y = edge.end


def _turn(ours: list[Point], i: int, theirs: list[Point], j: int) -> int:
    """Tell which edge comes next: positive, ours; negative, theirs; 0, both at once."""
    if i == len(ours):
        return -1
    if j == len(theirs):
        return 1
    a, b = ours[i], theirs[j]
    if is_upper(a) != is_upper(b):
        return 1 if is_upper(a) else -1
    return cross(a, b)


def angle(way: Point) -> float:
    """Return the direction of a vector in degrees, from 0 to 360, to be shown."""
    return atan2(way[1], way[0]) % (2 * pi) * 180 / pi


def reflected(polygon: Polygon) -> Polygon:
    """Return the polygon reflected in the origin; it stays counter-clockwise."""
    return [(-x, -y) for x, y in polygon]
