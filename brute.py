#!/usr/bin/env python3
"""Collision Course, the naive way: lines and their intersections, nothing cleverer.

Two convex polygons that first touch in the course of a straight move touch at a
vertex of one of them. So it is enough to draw

  * from every robot vertex, the segment that it travels, against every obstacle edge;
  * from every obstacle vertex, the same segment backwards, against every robot edge;

and to look whether the two already overlap before anything moves: some pair of
edges meets, or one polygon lies inside the other. (The edge pairs at the end of
the move add nothing to this, but cost little and make the argument easier to trust.)

Exact: integers only, closed sets. O(m * n) for each robot of m and obstacle of n
vertices, which is hopeless for large files: that is its point. It shares nothing
with solution.py, neither code nor idea, so that the two can check each other.
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

    Two segments cross if each has its ends on different sides of the other's line,
    or on it. Segments with parallel lines pass that test only if they lie on one
    line (a segment of length zero: only if its point does), and there they meet
    if and only if their bounding boxes do.
    """
    for ax, ay, ux, uy in first:
        for cx, cy, vx, vy in second:
            wx = cx - ax
            wy = cy - ay
            turn = ux * vy - uy * vx
            side = ux * wy - uy * wx  # of c to the line a + s u; of c + v: side + turn
            if side * (side + turn) <= 0:
                side = wx * vy - wy * vx  # of a to the line c + t v; of a + u: side - turn
                if side * (side - turn) <= 0 and (
                    turn or (ranges_meet(ax, ux, cx, vx) and ranges_meet(ay, uy, cy, vy))
                ):
                    return True
    return False


def ranges_meet(a: int, u: int, c: int, v: int) -> bool:
    """Do the closed ranges from a to a + u and from c to c + v share a number?"""
    return min(a, a + u) <= max(c, c + v) and min(c, c + v) <= max(a, a + u)


if __name__ == "__main__":
    main()
