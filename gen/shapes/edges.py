"""Edges sorted by angle: the stuff that convex polygons are made of."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from itertools import accumulate, pairwise

from gen.geometry import Point, Polygon

_SCALE = 60  # bits; two primitive directions with |x| + |y| < 2**29 get different keys


def angle_key(v: Point) -> int:
    """Return an integer that orders directions by angle in [0, 360) degrees, exactly.

    The fractions x / (|x| + |y|) of two directions differ by more than 2**-58 for
    |x| + |y| < 2**29, so the scaled quotients differ; equal directions get equal keys.
    """
    x, y = v
    quotient = (x << _SCALE) // (abs(x) + abs(y))
    if y > 0 or (y == 0 and x > 0):
        return -quotient
    return quotient + (2 << _SCALE)


def from_edges(edges: Iterable[Point]) -> Polygon:
    """Return the convex polygon with these edges, lowest then leftmost vertex first, at (0, 0).

    The edges sum to zero and span the plane; edges of one direction are joined.
    O(n log n).
    """
    return from_sorted_edges(sorted(edges, key=angle_key))


def from_sorted_edges(edges: list[Point]) -> Polygon:
    """As `from_edges`, for edges already ordered by angle from 0 up. O(n)."""
    joined = [edges[0]]
    for (ax, ay), (bx, by) in pairwise(edges):
        if ax * by == ay * bx and ax * bx + ay * by > 0:
            joined[-1] = (joined[-1][0] + bx, joined[-1][1] + by)
        else:
            joined.append((bx, by))
    xs = accumulate((x for x, _ in joined[:-1]), initial=0)
    ys = accumulate((y for _, y in joined[:-1]), initial=0)
    return list(zip(xs, ys, strict=True))


@cache
def directions(reach: int) -> tuple[Point, ...]:
    """Return every primitive (x, y) with |x|, |y| <= reach, by angle from 0 up.

    There are about 4.86 * reach^2. O(result): a walk along the Farey sequence.
    Source: Graham, Knuth, Patashnik, Concrete Mathematics, 4.5.
    """
    octant = [(1, 0)]  # (x, y) for the fractions y / x from 0 to 1
    a, b, c, d = 0, 1, 1, reach
    while c <= reach and a < b:
        octant.append((d, c))
        step = (reach + b) // d
        a, b, c, d = c, d, step * c - a, step * d - b
    quadrant = octant + [(y, x) for x, y in octant[-2:0:-1]]
    half = quadrant + [(-y, x) for x, y in quadrant]
    if reach == 1:  # the octant is (1, 0), (1, 1): nothing is doubled above but nothing lost
        half = [(1, 0), (1, 1), (0, 1), (-1, 1)]
    return tuple(half + [(-x, -y) for x, y in half])


def reach_for(n: int) -> int:
    """Return a reach whose directions are at least n, and not many more than needed."""
    reach = 1
    while len(directions(reach)) < n:
        reach = reach + max(1, reach // 8)
    return reach
