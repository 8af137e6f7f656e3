"""Edges sorted by angle, from which convex polygons are made."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from functools import cache
from itertools import accumulate

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


def closed(edges: Sequence[Point]) -> Polygon:
    """Return the convex polygon of these edges and the one that closes them.

    edges: no two of one direction, ordered by angle from 0 up. The lowest, then leftmost,
    vertex is (0, 0) and comes first. One vertex per edge, one less if the closing edge is
    zero or goes on in the direction of another; [] when the edges span no area.
    O(n) additions, O(log n) comparisons of angles.
    """
    xs, ys = [x for x, _ in edges], [y for _, y in edges]
    close_x, close_y = -sum(xs), -sum(ys)
    if close_x or close_y:
        key = angle_key((close_x, close_y))
        at = bisect_left(edges, key, key=angle_key)
        if at < len(edges) and angle_key(edges[at]) == key:
            xs[at] += close_x
            ys[at] += close_y
        else:
            xs.insert(at, close_x)
            ys.insert(at, close_y)
    if all(xs[0] * y == ys[0] * x for x, y in zip(xs, ys, strict=True)):
        return []
    xs.pop()
    ys.pop()
    return list(zip(accumulate(xs, initial=0), accumulate(ys, initial=0), strict=True))


@cache
def directions(reach: int) -> tuple[Point, ...]:
    """Return every primitive (x, y) with |x|, |y| <= reach, by angle from 0 up.

    There are about 4.86 * reach^2. O(result).
    """
    return tuple(directions_from(reach, 0, number_of_directions(reach)))


def directions_from(reach: int, start: int, count: int) -> list[Point]:
    """Return `count` consecutive items of `directions`, beginning with index `start`, cyclically.

    O(count + reach^2), a quarter of the work for all of them if count is small.
    """
    quadrant = _first_quadrant(reach)
    size = len(quadrant)
    found: list[Point] = []
    while count > 0:
        turns, first = divmod(start % (4 * size), size)
        part = quadrant[first : first + count]
        if turns == 1:
            part = [(-y, x) for x, y in part]
        elif turns == 2:
            part = [(-x, -y) for x, y in part]
        elif turns == 3:
            part = [(y, -x) for x, y in part]
        found += part
        start += len(part)
        count -= len(part)
    return found


@cache
def _first_quadrant(reach: int) -> list[Point]:
    """Return the directions from 0 up to, but not including, 90 degrees, by angle.

    A walk along the Farey sequence. Source: Graham, Knuth, Patashnik, Concrete
    Mathematics, 4.5.
    """
    octant = [(1, 0)]  # (x, y) for the fractions y / x from 0 to 1
    a, b, c, d = 0, 1, 1, reach
    while c <= reach and a < b:
        octant.append((d, c))
        step = (reach + b) // d
        a, b, c, d = c, d, step * c - a, step * d - b
    return octant + [(y, x) for x, y in octant[-2:0:-1]]


def number_of_directions(reach: int) -> int:
    """Return how many directions there are: 8 times the sum of Euler's totients up to reach.

    O(reach log log reach).
    """
    totients = list(range(reach + 1))
    for prime in range(2, reach + 1):
        if totients[prime] == prime:
            for multiple in range(prime, reach + 1, prime):
                totients[multiple] -= totients[multiple] // prime
    return 8 * sum(totients)


@cache
def reach_for(n: int) -> int:
    """Return a reach whose directions are at least n, and not many more than needed."""
    reach = 1
    while number_of_directions(reach) < n:
        reach = reach + max(1, reach // 8)
    return reach
