"""Vectors, hulls, the sweep of a convex robot, and a slow test whether polygons meet."""

from __future__ import annotations

from dataclasses import dataclass
from math import gcd

Point = tuple[int, int]
Polygon = list[Point]


def cross(a: Point, b: Point) -> int:
    """Return the cross product a x b: positive when b points to the left of a."""
    return a[0] * b[1] - a[1] * b[0]


def minus(a: Point, b: Point) -> Point:
    """Return the vector from b to a."""
    return a[0] - b[0], a[1] - b[1]


def primitive(v: Point) -> Point:
    """Return the shortest integer vector of v's direction; v is not zero."""
    divisor = gcd(v[0], v[1])
    return v[0] // divisor, v[1] // divisor


def step_right(w: Point) -> Point:
    """Return an integer vector s with cross(w, s) == -1 for a primitive w.

    It leads from the line along w to the next lattice line on its right. Among the
    solutions, the one with 0 <= dot(w, s) < |w|^2 is taken. O(log |w|).
    """
    # p*v - q*u == -1: v is minus the inverse of p modulo q, and u follows.
    p, q = w
    v = -pow(p, -1, abs(q)) if q else -p
    u = (p * v + 1) // q if q else 0
    shift = (u * p + v * q) // (p * p + q * q)
    return u - shift * p, v - shift * q


def translated(polygon: Polygon, by: Point) -> Polygon:
    """Return the polygon moved by a vector."""
    dx, dy = by
    return [(x + dx, y + dy) for x, y in polygon]


def hull(points: Polygon) -> Polygon:
    """Return the strictly convex hull, counter-clockwise; fewer than 3 points when degenerate.

    O(n log n). Source: Andrew's monotone chain.
    """
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered
    if len(ordered) == 3:
        a, b, c = ordered
        turn = cross(minus(b, a), minus(c, b))
        return [a, b, c] if turn > 0 else [a, c, b] if turn else [a, c]
    lower = _chain(ordered)
    ordered.reverse()
    return lower + _chain(ordered)


def _chain(ordered: Polygon) -> Polygon:
    """Return the hull's vertices from the first of the ordered points up to before the last."""
    chain: Polygon = []
    for point in ordered:
        x, y = point
        while len(chain) >= 2:
            (ax, ay), (bx, by) = chain[-2], chain[-1]
            if (bx - ax) * (y - by) > (by - ay) * (x - bx):
                break
            chain.pop()
        chain.append(point)
    chain.pop()
    return chain


def is_strictly_convex(polygon: Polygon) -> bool:
    """Tell whether the polygon is counter-clockwise, strictly convex and winds once. O(n)."""
    if len(polygon) < 3:
        return False
    windings = 0
    back = minus(polygon[-1], polygon[-2])
    here = polygon[-1]
    for point in polygon:
        ahead = minus(point, here)
        if cross(back, ahead) <= 0:
            return False
        windings += not is_upper(back) and is_upper(ahead)
        back, here = ahead, point
    return windings == 1


def is_upper(v: Point) -> bool:
    """Tell whether v's angle lies in [0, 180) degrees."""
    return v[1] > 0 or (v[1] == 0 and v[0] > 0)


@dataclass(frozen=True)
class Sweep:
    """What a convex robot covers: a convex polygon, and where its parts begin.

    vertices: the rear (from the start), then the front (from the end of the move).
    front: index of the first front vertex. Without a move: 0, everything is front.
    The edge that ends at `front` and the one that closes the polygon lie along the
    move; they are longer than the move where a robot's edge is parallel to it.
    """

    vertices: Polygon
    front: int

    def edge(self, index: int) -> tuple[Point, Point]:
        """Return both ends of the edge that leaves vertex `index`."""
        return self.vertices[index], self.vertices[(index + 1) % len(self.vertices)]


def sweep(robot: Polygon, move: Point) -> Sweep:
    """Return the convex polygon that the robot covers on its straight move. O(m)."""
    if move == (0, 0):
        return Sweep(list(robot), 0)
    dx, dy = move
    m = len(robot)
    sides = [dx * y - dy * x for x, y in robot]
    right, left = min(sides), max(sides)
    # Of two vertices on a side line the edge between them melts into the swept side:
    # its outer ends stay. Counter-clockwise runs along the move on the right.
    rear_end = sides.index(right)
    rear_end -= sides[rear_end - 1] == right  # the first and the last vertex
    rear_start = sides.index(left)
    rear_start += sides[(rear_start + 1) % m] == left
    front_start = rear_end + (sides[(rear_end + 1) % m] == right)
    front_end = rear_start - (sides[rear_start - 1] == left)
    rear = _arc(robot, rear_start, rear_end)
    front = translated(_arc(robot, front_start, front_end), move)
    return Sweep(rear + front, len(rear))


def _arc(polygon: Polygon, first: int, last: int) -> Polygon:
    """Return the vertices from index `first` on to index `last`, both modulo n."""
    n = len(polygon)
    first, last = first % n, last % n
    if first <= last:
        return polygon[first : last + 1]
    return polygon[first:] + polygon[: last + 1]


def apart(a: Polygon, b: Polygon) -> bool:
    """Tell whether two convex polygons share no point, by trying every edge. O(len(a) * len(b))."""
    return _edge_parts(a, b) or _edge_parts(b, a)


def _edge_parts(a: Polygon, b: Polygon) -> bool:
    """Tell whether the line through some edge of a has all of b strictly outside."""
    ax, ay = a[-1]
    for bx, by in a:
        ex, ey = bx - ax, by - ay
        level = ex * ay - ey * ax
        for x, y in b:
            if ex * y - ey * x >= level:
                break
        else:
            return True
        ax, ay = bx, by
    return False
