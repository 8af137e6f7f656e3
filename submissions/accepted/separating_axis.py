#!/usr/bin/env python3
"""Separating axis, found by cutting caps: no chains are merged, no sum is walked.

The sweep S misses an obstacle Q if and only if some line separates them: if and only
if, in some direction, the origin lies strictly farther out than every point of the
difference D = Q - S.

Let a, b be two outermost points of D such that the origin is on the right of the chord
a -> b. The chord cuts off a cap of D, on the side of the origin. Let p be the point of
the cap that is farthest from the chord. Either the origin is beyond the tangent at p,
which is parallel to the chord: S and Q are separated. Or it is in the triangle a p b:
they meet. Or it is beyond one of the chords a -> p, p -> b, which cuts off a smaller
cap. Every cut leaves a cap of at most a quarter of the area, which is soon too small
to hold an integer point: about 30 cuts at most, mostly three to eight.

The outermost point of D is that of Q minus the opposite one of S. Both are found by
binary search among the polygon's edges by angle; few vertices are simply tried.

Time: O(m) per robot, and O((log m + min(n, log n)) * cuts) + O(n) per obstacle.
"""

import sys
from bisect import bisect_left

TRIED_ONE_BY_ONE = 8  # for so few vertices a search costs more than trying them all
NARROW = 32  # the first chord cuts off about so many robot edges to either side of a guess
BITS = 68  # an edge (|x| + |y| < 2**30) and any direction below 2**37 differ by over 2**-67


def main() -> None:
    numbers = list(map(int, sys.stdin.buffer.read().split()))
    answers = []
    at = 1
    for _ in range(numbers[0]):
        m, k, dx, dy = numbers[at : at + 4]
        at += 4
        px, py = numbers[at : at + 2 * m : 2], numbers[at + 1 : at + 2 * m : 2]
        at += 2 * m
        farthest_in_robot = farthest_search(px, py)
        edges_near = edges_at_height(px, py)
        middle = (px[0] + px[m // 2] + dx) // 2, (py[0] + py[m // 2] + dy) // 2
        free = True
        for _ in range(k):
            n = numbers[at]
            end = at + 1 + 2 * n
            if free:  # after a collision the other obstacles are only skipped
                qx, qy = numbers[at + 1 : end : 2], numbers[at + 2 : end : 2]
                gx, gy = middle[0] - qx[0], middle[1] - qy[0] or 1
                # Ahead of the middle the sweep is the robot at its end.
                height = qy[0] - dy if gx * dx + gy * dy < 0 else qy[0]
                guess = edges_near(gx < 0, height)
                free = not meet(farthest_search(qx, qy), farthest_in_robot, dx, dy, guess)
            at = end
        answers.append("YES" if free else "NO")
    print("\n".join(answers))


def meet(farthest_in_obstacle, farthest_in_robot, dx, dy, guess):
    """Tell whether D = Q - S holds the origin, boundary included.

    guess: two directions, between which a line may separate them. Only the time depends
    on it.
    """

    def farthest(wx, wy):
        """Return the point of D farthest to the right of the direction w."""
        qx, qy = farthest_in_obstacle(wx, wy)
        px, py = farthest_in_robot(-wx, -wy)
        if wx * dy > wy * dx:  # S is the robot at its start and at its end
            return qx - px - dx, qy - py - dy
        return qx - px, qy - py

    # The first chord: a narrow one where the origin may be.
    ax, ay = farthest(*guess[0])
    bx, by = farthest(*guess[1])
    if ax * by >= ay * bx:
        # The origin is not out there; the chord from the right end of D to its left end, or back.
        ax, ay = farthest(0, 1)
        bx, by = farthest(0, -1)
        if ax < 0 or bx > 0:
            return False
        if ax * by > ay * bx:
            ax, ay, bx, by = bx, by, ax, ay
    # Now the origin is on the right of a -> b, or on the chord itself.
    while True:
        wx, wy = bx - ax, by - ay
        px, py = farthest(wx, wy)
        if wx * py > wy * px:
            return False  # the origin is beyond all of D
        if ax * py < ay * px:
            bx, by = px, py
        elif px * by < py * bx:
            ax, ay = px, py
        else:
            return True  # the origin is in the triangle a p b


def farthest_search(xs, ys):
    """Return a function of w: the vertex (x, y) farthest to the right of the direction w."""
    n = len(xs)
    if n <= TRIED_ONE_BY_ONE:
        corners = list(zip(xs, ys))

        def farthest_of_few(wx, wy):
            x, y = corners[0]
            least = wx * y - wy * x
            for cx, cy in corners:
                side = wx * cy - wy * cx
                if side < least:
                    least, x, y = side, cx, cy
            return x, y

        return farthest_of_few

    # From the lowest, leftmost vertex on, the edges' angles grow from 0 to 360 degrees;
    # the farthest vertex is the one where they turn past the direction w.
    xs, ys = from_lowest(xs, ys)
    keys = [angle_key(xs[i + 1] - xs[i], ys[i + 1] - ys[i]) for i in range(n)]

    def farthest(wx, wy):
        i = bisect_left(keys, angle_key(wx, wy))
        return xs[i], ys[i]

    return farthest


def edges_at_height(xs, ys):
    """Return a function of (right, y): the reverse directions of two robot edges.

    They are a few edges before and after the one that is at the height y on the robot's
    right or left side. Heights beyond the robot's are taken for its highest or lowest.
    """
    xs, ys = from_lowest(xs, ys)
    n = len(xs) - 1
    top = max(range(n), key=ys.__getitem__)
    falling = [-y for y in ys]

    def edges_near(right, y):
        i = bisect_left(ys, y, 0, top) if right else bisect_left(falling, -y, top, n)
        a, b = (i - NARROW) % n, (i + NARROW) % n
        return (xs[a] - xs[a + 1], ys[a] - ys[a + 1]), (xs[b] - xs[b + 1], ys[b] - ys[b + 1])

    return edges_near


def from_lowest(xs, ys):
    """Return the polygon from its lowest, then leftmost, vertex round to that vertex again."""
    lowest = min(ys)
    start = min((i for i, y in enumerate(ys) if y == lowest), key=xs.__getitem__)
    return xs[start:] + xs[: start + 1], ys[start:] + ys[: start + 1]


def angle_key(x, y):
    """Return an integer that orders directions by their angle in [0, 360) degrees, exactly."""
    cosine_like = (x << BITS) // (abs(x) + abs(y))
    return -cosine_like if y > 0 or (y == 0 and x > 0) else cosine_like + (2 << BITS)


if __name__ == "__main__":
    main()
