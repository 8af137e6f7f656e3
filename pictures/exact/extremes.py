"""The farthest vertex of a convex polygon in a direction, fast also where there are many."""

from __future__ import annotations

from array import array  # less memory to search than in a list
from bisect import bisect_left
from functools import cached_property
from itertools import chain, pairwise
from math import atan2
from operator import itemgetter

from gen.geometry import Point, Polygon

SMALL = 12  # up to so many vertices, looking at all of them is faster than searching


class Extremes:
    """A convex polygon that can be asked for its extreme vertices.

    polygon: counter-clockwise, strictly convex.
    """

    def __init__(self, polygon: Polygon) -> None:
        self.polygon = polygon

    @cached_property
    def _first(self) -> int:
        """The highest vertex, the leftmost of two: from there on, the edges' angles grow."""
        polygon = self.polygon
        top = max(polygon, key=itemgetter(1))
        at = polygon.index(top)
        after = (at + 1) % len(polygon)
        return after if polygon[after][1] == top[1] else at

    @cached_property
    def _angles(self) -> array[float]:
        """The directions of the edges from `_first` on, in (-pi, pi], about sorted."""
        p, first = self.polygon, self._first
        edges = pairwise(chain(p[first:], p[: first + 1]))
        return array("d", [atan2(by - ay, bx - ax) for (ax, ay), (bx, by) in edges])

    def farthest(self, ux: int, uy: int) -> int:
        """Return the index of a vertex (x, y) with the greatest ux * x + uy * y.

        Exact: floats only say where to begin. O(log n) after O(n) for the first question.
        """
        polygon = self.polygon
        n = len(polygon)
        if n <= SMALL:
            levels = [ux * x + uy * y for x, y in polygon]
            return levels.index(max(levels))
        at = (self._first + bisect_left(self._angles, atan2(ux, -uy))) % n
        x, y = polygon[at]
        level = ux * x + uy * y
        for step in (1, -1):
            while True:
                x, y = polygon[(at + step) % n]
                if ux * x + uy * y <= level:
                    break
                at, level = (at + step) % n, ux * x + uy * y
        return at

    def face(self, ux: int, uy: int) -> tuple[Point, ...]:
        """Return all vertices that are farthest in a direction: one, or the two of an edge."""
        polygon = self.polygon
        at = self.farthest(ux, uy)
        x, y = here = polygon[at]
        level = ux * x + uy * y
        bx, by = before = polygon[at - 1]
        if ux * bx + uy * by == level:
            return before, here
        ax, ay = after = polygon[(at + 1) % len(polygon)]
        return (here, after) if ux * ax + uy * ay == level else (here,)
