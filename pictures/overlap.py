"""The exact intersection of two convex polygons, to show why an answer is NO."""

from __future__ import annotations

from fractions import Fraction

from gen.geometry import Polygon
from pictures.cut import cut
from pictures.exact.meeting import ExactPoint


def overlap(p: Polygon, q: Polygon) -> list[ExactPoint]:
    """Return the intersection of two convex polygons as a polygon.

    Counter-clockwise; empty if they share no point, one or two points if they only touch.
    Exact; O(n * m). Source: Sutherland and Hodgman, Reentrant polygon clipping, 1974.
    """
    points = [(Fraction(x), Fraction(y)) for x, y in p]
    for (ax, ay), (bx, by) in zip(q, q[1:] + q[:1], strict=True):
        heights = [(bx - ax) * (y - ay) - (by - ay) * (x - ax) for x, y in points]
        points = list(dict.fromkeys(cut(points, heights)))
    return points
