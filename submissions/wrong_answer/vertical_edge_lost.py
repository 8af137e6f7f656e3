#!/usr/bin/env python3
"""Begins the lower chain at any leftmost vertex: of two, it may be the upper one.

Where the left edge is vertical, the chain must begin at its lower end. From the upper end it
leads over the polygon, whose lower left corner is lost.
"""

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
    minus_p, minus_q = reflected(p), reflected(q)
    # The ceiling of a polygon is the floor of its reflection.
    return floor_is_low(p, minus_q) and floor_is_low(minus_p, q)


def reflected(polygon):
    return [(-x, -y) for x, y in polygon]


def floor_is_low(p, q):
    """Does the sum of two polygons have a point (0, y) with y <= 0?

    Its floor has the edges of both floors, by slope.
    """
    p, q = floor(p), floor(q)
    i = j = 0
    x, y = p[0][0] + q[0][0], p[0][1] + q[0][1]
    if x >= 0:
        return x == 0 and y <= 0
    while i + 1 < len(p) or j + 1 < len(q):
        if j + 1 == len(q) or (i + 1 < len(p) and flatter(p[i], p[i + 1], q[j], q[j + 1])):
            i += 1
        else:
            j += 1
        x2, y2 = p[i][0] + q[j][0], p[i][1] + q[j][1]
        if x2 >= 0:  # this edge passes x = 0
            return y * (x2 - x) <= x * (y2 - y)
        x, y = x2, y2
    return False


def flatter(a, b, c, d):
    """Is the slope of the edge ab less than that of cd?"""
    return (b[1] - a[1]) * (d[0] - c[0]) < (d[1] - c[1]) * (b[0] - a[0])


def floor(polygon):
    """Return the lower chain, from the leftmost vertex to the rightmost."""
    n = len(polygon)
    at = min(range(n), key=lambda i: polygon[i][0])
    end = max(range(n), key=lambda i: polygon[i][0])
    chain = [polygon[at]]
    while at != end:
        at = (at + 1) % n
        if polygon[at][0] > chain[-1][0]:  # a vertical edge is no part of a floor
            chain.append(polygon[at])
    return chain


if __name__ == "__main__":
    main()
