"""What lies inside a convex polygon; its boundary belongs to it."""

from __future__ import annotations

from collections.abc import Iterator

from gen.geometry import Point, Polygon
from pictures.exact.extremes import Extremes


def lies_within(inner: Polygon, outer: Polygon) -> bool:
    """Tell whether all of one convex polygon lies in another. O(m + n)."""
    m = len(inner)
    ax, ay = outer[-1]
    bx, by = outer[0]
    at = Extremes(inner).farthest(by - ay, ax - bx)
    for bx, by in outer:
        ux, uy = bx - ax, by - ay
        x, y = inner[at]
        side = ux * (y - ay) - uy * (x - ax)
        while True:  # the vertex farthest to the right of the edge goes round as the edge does
            x, y = inner[(at + 1) % m]
            after = ux * (y - ay) - uy * (x - ax)
            if after >= side:
                break
            at, side = (at + 1) % m, after
        if side < 0:
            return False
        ax, ay = bx, by
    return True


class Container:
    """A convex polygon that is asked for the points inside it."""

    def __init__(self, polygon: Polygon) -> None:
        self.polygon = polygon

    def inside(self, points: Polygon) -> Iterator[Point]:
        """Yield those of the points that lie in it, boundary included. O(log n) each."""
        xs, ys = zip(*self.polygon, strict=True)
        left, right, bottom, top = min(xs), max(xs), min(ys), max(ys)
        for x, y in points:
            if left <= x <= right and bottom <= y <= top and self._holds(x, y):
                yield x, y

    def _holds(self, x: int, y: int) -> bool:
        """Tell whether a point lies in it: bisect the fan of triangles from the first vertex."""
        polygon = self.polygon
        (ax, ay) = polygon[0]
        x, y = x - ax, y - ay
        low, high = 1, len(polygon) - 1
        while high - low > 1:
            middle = (low + high) // 2
            bx, by = polygon[middle]
            if (bx - ax) * y >= (by - ay) * x:
                low = middle
            else:
                high = middle
        (bx, by), (cx, cy) = polygon[low], polygon[high]
        return (
            (bx - ax) * y >= (by - ay) * x
            and (cx - ax) * y <= (cy - ay) * x
            and (cx - bx) * (y + ay - by) >= (cy - by) * (x + ax - bx)
        )
