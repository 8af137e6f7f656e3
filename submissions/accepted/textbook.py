#!/usr/bin/env python3
"""The lesson itself: one Minkowski sum of convex polygons for each obstacle.

1. All that the robot ever covers on its way, the sweep, is the convex hull of the
   robot at its start and the robot at its end: the Minkowski sum of the robot and
   the segment from (0, 0) to (dx, dy).
2. The sweep S and an obstacle Q share a point  s = q  if and only if  s - q = 0:
   if and only if the origin lies in  S + (-Q),  boundary included.
3. The sum of two convex polygons is convex, and its boundary is made of the edges
   of both, in the order of their directions. Both lists are in that order already
   when they start at the lowest vertex (the leftmost, if there are two), so the
   sum is one merge.

O(m) for the sweep and O(m + n) for each obstacle: O(k * m + N) per scenario. That
passes every group but `many`, where the robot is too large to be walked once for
each obstacle; solution.py says how to avoid that.
"""

import sys


def main():
    numbers = list(map(int, sys.stdin.buffer.read().split()))
    at = 1
    answers = []
    for _ in range(numbers[0]):
        m, k, dx, dy = numbers[at : at + 4]
        robot, at = read_polygon(numbers, at + 4, m)
        sweep = minkowski_sum(robot, [(0, 0), (dx, dy)]) if dx or dy else robot
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


def touch(p, q):
    """Do two convex polygons share a point? If and only if 0 is in p + (-q)."""
    return contains_origin(minkowski_sum(p, [(-x, -y) for x, y in q]))


def minkowski_sum(p, q):
    """Return all sums of a point of p and a point of q: a convex polygon again.

    The edges of both are merged by angle. Edges of equal direction are taken
    together, so that the result is strictly convex. A segment is a polygon of two
    vertices here, and of two edges: there and back.
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
