#!/usr/bin/env python3
"""Begins the walk at any lowest vertex: of two, it may be the one on the right.

The edges are sorted by angle, so a horizontal bottom edge is walked first: from its right end
that leads out of the polygon, and the whole sum is moved by its length.
"""

import functools
import sys


def main():
    numbers = list(map(int, sys.stdin.buffer.read().split()))
    at = 1
    answers = []
    for _ in range(numbers[0]):
        m, k, dx, dy = numbers[at : at + 4]
        robot, at = read_polygon(numbers, at + 4, m)
        sweep = convex_hull(robot + [(x + dx, y + dy) for x, y in robot])
        answer = "YES"
        for _ in range(k):
            obstacle, at = read_polygon(numbers, at + 1, numbers[at])
            # After the first collision, the other obstacles are only read.
            if answer == "YES" and touch(sweep, obstacle):
                answer = "NO"
        answers.append(answer)
    print("\n".join(answers))


def read_polygon(numbers, at, n):
    """Return the n points (x, y) that begin at index `at`, and the index behind them."""
    end = at + 2 * n
    return list(zip(numbers[at:end:2], numbers[at + 1 : end : 2])), end


def convex_hull(points):
    """Return the strictly convex hull, counter-clockwise (Andrew's monotone chain)."""
    points = sorted(set(points))
    return half_hull(points)[:-1] + half_hull(points[::-1])[:-1]


def half_hull(points):
    """Return the chain that only turns left, from the first point to the last."""
    chain = []
    for x, y in points:
        while len(chain) > 1:
            (ax, ay), (bx, by) = chain[-2:]
            if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 0:
                break
            chain.pop()
        chain.append((x, y))
    return chain


def touch(p, q):
    """Do two convex polygons share a point? If and only if 0 is in p + (-q)."""
    return contains_origin(minkowski_sum(p, [(-x, -y) for x, y in q]))


def minkowski_sum(p, q):
    """Return all sums of a point of p and a point of q: a convex polygon again.

    The edges of both are sorted by angle, and walked from the lowest vertex on.
    """
    p = from_lowest(p)
    q = from_lowest(q)
    x, y = p[0][0] + q[0][0], p[0][1] + q[0][1]
    total = []
    for ux, uy in sorted(edges(p) + edges(q), key=functools.cmp_to_key(by_angle)):
        total.append((x, y))
        x, y = x + ux, y + uy
    return total


def edges(boundary):
    """Return the ways from each vertex to the next."""
    return [(bx - ax, by - ay) for (ax, ay), (bx, by) in zip(boundary, boundary[1:])]


def by_angle(a, b):
    """Compare two directions by angle from 0 up to 360 degrees: negative if a comes first."""
    halves = is_lower_half(*a) - is_lower_half(*b)
    return halves or a[1] * b[0] - a[0] * b[1]


def is_lower_half(x, y):
    """Is the direction (x, y) between 180 and 360 degrees, 180 included?"""
    return y < 0 or (y == 0 and x < 0)


def from_lowest(polygon):
    """Return the polygon from its lowest vertex round to that vertex again."""
    start = min(range(len(polygon)), key=lambda i: polygon[i][1])
    return polygon[start:] + polygon[: start + 1]


def contains_origin(polygon):
    """Is (0, 0) in the counter-clockwise polygon? Left of every edge, or on it."""
    ax, ay = polygon[-1]
    for bx, by in polygon:
        if ax * by < ay * bx:
            return False
        ax, ay = bx, by
    return True


if __name__ == "__main__":
    main()
