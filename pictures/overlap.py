"""The exact intersection of two convex polygons, to show why an answer is NO."""

from __future__ import annotations

from fractions import Fraction

from gen.geometry import Polygon

ExactPoint = tuple[Fraction, Fraction]


def overlap(p: Polygon, q: Polygon) -> list[ExactPoint]:
    """Return the intersection of two convex polygons as a polygon.

    Counter-clockwise; empty if they share no point, one or two points if they only touch.
    Exact; O(n * m). Source: Sutherland and Hodgman, Reentrant polygon clipping, 1974.
    """
    points = [(Fraction(x), Fraction(y)) for x, y in p]
    for (ax, ay), (bx, by) in zip(q, q[1:] + q[:1], strict=True):
        heights = [(bx - ax) * (y - ay) - (by - ay) * (x - ax) for x, y in points]
        clipped: list[ExactPoint] = []
        for i, (x, y) in enumerate(points):
            before = heights[i - 1]
            here = heights[i]
            if before * here < 0:
                px, py = points[i - 1]
                part = before / (before - here)
                clipped.append((px + part * (x - px), py + part * (y - py)))
            if here >= 0:
                clipped.append((x, y))
        points = list(dict.fromkeys(clipped))
    return points
