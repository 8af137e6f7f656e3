#!/usr/bin/env python3
"""Takes dx = 0 for no move at all: a robot that moves straight up or down stays where it is."""

import sys


def main():
    numbers = list(map(int, sys.stdin.buffer.read().split()))
    at = 1
    answers = []
    for _ in range(numbers[0]):
        m, k, dx, dy = numbers[at : at + 4]
        robot, at = read_polygon(numbers, at + 4, m)
        sweep = robot
        if dx != 0:
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

    The edges of both are merged by angle. Edges of equal direction are taken
    together, so that the result is strictly convex.
    """
    p = from_lowest(p)
    q = from_lowest(q)
    n, m = len(p) - 1, len(q) - 1
    i = j = 0
    total = []
    while i < n or j < m:
        px, py = p[i]
        qx, qy = q[j]
        total.append((px + qx, py + qy))
        if i == n:
            turn = -1
        elif j == m:
            turn = 1
        else:  # which edge turns less? the one of p, if the one of q lies to its left
            px2, py2 = p[i + 1]
            qx2, qy2 = q[j + 1]
            turn = (px2 - px) * (qy2 - qy) - (py2 - py) * (qx2 - qx)
        if turn >= 0:
            i += 1
        if turn <= 0:
            j += 1
    return total


def from_lowest(polygon):
    """Return the polygon from its lowest, then leftmost, vertex round to that vertex again."""
    start = min(range(len(polygon)), key=lambda i: (polygon[i][1], polygon[i][0]))
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
