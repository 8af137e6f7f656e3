#!/usr/bin/env python3
"""Puts the two outermost corners across the move into the hull only where the robot ends.

There the front of the robot passes into its back, so both their places belong to the hull: at
the start and at the end.
"""

import sys


def main():
    numbers = list(map(int, sys.stdin.buffer.read().split()))
    at = 1
    answers = []
    for _ in range(numbers[0]):
        m, k, dx, dy = numbers[at : at + 4]
        robot, at = read_polygon(numbers, at + 4, m)
        sweep = swept_area(robot, dx, dy)
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


def swept_area(robot, dx, dy):
    """Return the hull of the robot at its start and at its end.

    Corners between two edges that lead are where the robot ends, others where it starts.
    """
    corners = []
    for i, (x, y) in enumerate(robot):
        before, after = robot[i - 1], robot[(i + 1) % len(robot)]
        if leads(before, (x, y), dx, dy) or leads((x, y), after, dx, dy):
            corners.append((x + dx, y + dy))
        else:
            corners.append((x, y))
    return corners


def leads(a, b, dx, dy):
    """Is the edge from a to b at the front of a robot that moves by (dx, dy)?"""
    return (b[1] - a[1]) * dx - (b[0] - a[0]) * dy > 0


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
