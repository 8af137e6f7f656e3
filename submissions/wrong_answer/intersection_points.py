#!/usr/bin/env python3
"""Computes where the lines cross, in floating point, and asks whether that point is on both.

The crossing is rounded, and a corner that is just reached, or just missed, at 10^8 is decided
by the rounding.
"""

import sys
from collections.abc import Iterator

Point = tuple[int, int]
Segment = tuple[int, int, int, int]  # an end point, and the way to the other: x, y, ux, uy


def main() -> None:
    numbers = map(int, sys.stdin.buffer.read().split())
    answers = []
    for _ in range(next(numbers)):
        m, k, dx, dy = (next(numbers) for _ in range(4))
        robot = read_polygon(numbers, m)
        obstacles = [read_polygon(numbers, next(numbers)) for _ in range(k)]
        hit = any(collide(robot, obstacle, dx, dy) for obstacle in obstacles)
        answers.append("NO" if hit else "YES")
    print("\n".join(answers))


def read_polygon(numbers: Iterator[int], n: int) -> list[Point]:
    """Return the next n points (x, y) of the stream."""
    return [(next(numbers), next(numbers)) for _ in range(n)]


def collide(robot: list[Point], obstacle: list[Point], dx: int, dy: int) -> bool:
    """Does the robot, moving by (dx, dy), ever touch the obstacle?"""
    goal = [(x + dx, y + dy) for x, y in robot]
    return (
        some_meet(edges(robot), edges(obstacle))
        or contains(obstacle, robot[0])
        or contains(robot, obstacle[0])
        or some_meet([(x, y, dx, dy) for x, y in robot], edges(obstacle))
        or some_meet([(x, y, -dx, -dy) for x, y in obstacle], edges(robot))
        or some_meet(edges(goal), edges(obstacle))
    )


def edges(polygon: list[Point]) -> list[Segment]:
    """Return the edges, counter-clockwise."""
    return [
        (x, y, next_x - x, next_y - y)
        for (x, y), (next_x, next_y) in zip(polygon, polygon[1:] + polygon[:1])
    ]


def contains(polygon: list[Point], point: Point) -> bool:
    """Is the point inside the counter-clockwise polygon, or on its boundary?"""
    px, py = point
    return all(ux * (py - y) - uy * (px - x) >= 0 for x, y, ux, uy in edges(polygon))


def some_meet(first: list[Segment], second: list[Segment]) -> bool:
    """Does any segment of one list share a point with any of the other?

    The lines cross at a + s u = c + t v, and both s and t must be in [0, 1]. Segments with
    parallel lines meet if they lie on one line and their bounding boxes meet.
    """
    for ax, ay, ux, uy in first:
        for cx, cy, vx, vy in second:
            wx = cx - ax
            wy = cy - ay
            turn = float(ux * vy - uy * vx)
            if turn:
                s = (wx * vy - wy * vx) / turn
                t = (wx * uy - wy * ux) / turn
                x = ax + s * ux
                if 0 <= s <= 1 and 0 <= t <= 1 and abs(x - (cx + t * vx)) < 1e-6:
                    return True
            elif (
                wx * vy == wy * vx
                and wx * uy == wy * ux
                and ranges_meet(ax, ux, cx, vx)
                and ranges_meet(ay, uy, cy, vy)
            ):
                return True
    return False


def ranges_meet(a: int, u: int, c: int, v: int) -> bool:
    """Do the closed ranges from a to a + u and from c to c + v share a number?"""
    return min(a, a + u) <= max(c, c + v) and min(c, c + v) <= max(a, a + u)


if __name__ == "__main__":
    main()
