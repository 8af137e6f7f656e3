"""Corners between two long edges that differ by the least angle there is.

Attacks floating-point angles and slopes: they take the two directions for equal, or order them
the wrong way round.
"""

from __future__ import annotations

from collections.abc import Iterator

from gen.families.common import filled
from gen.families.registry import Move, Scenarios, Vertices, family
from gen.geometry import Point, cross, hull, primitive, step_right, translated
from gen.rng import Rng
from gen.scenario import LIMIT, Scenario

LONGEST = 9 * LIMIT // 10


SHORTEST = LIMIT // 4


@family
def slivers(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """Two directions of up to 10^8 units have a cross product of one: which comes first?

    One is that of a robot's edge; the other that of an obstacle's edge, reflected, or of the
    move. The obstacle touches the corner between them and nothing else (NO), or its vertex
    is on the next lattice line (YES). The angles differ by some 10^-16, so floating-point
    angles and slopes are equal or in the wrong order.
    """

    def make() -> Scenario:
        a, b = _neighbours(rng)
        still = move == "zero" or rng.chance(0.5)
        # The corner is (0, 0): a arrives there, b leaves, and the robot is on the left of both.
        robot = hull([(-a[0], -a[1]), (0, 0), *_points(rng, a, b, 1)])
        # Reflected, the obstacle's edge leaves its vertex (0, 0) in the direction b.
        edge = [(-b[0], -b[1])] if still else []
        obstacle = hull([(0, 0), *edge, *_points(rng, a, b, -1)])
        if rng.chance(0.65):  # of these fewer fit the world
            # Both are on the first lattice line to the right of the corner's line a + b.
            obstacle = translated(obstacle, rng.choice((a, (-b[0], -b[1]))))
        if still and rng.chance(0.5):
            robot, obstacle = obstacle, robot
        return Scenario(robot, (0, 0) if still else b, [obstacle])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=False)


def _neighbours(rng: Rng) -> tuple[Point, Point]:
    """Return two long vectors within 90 degrees with cross product 1."""
    while True:
        x, y = primitive((rng.between(SHORTEST, LONGEST), rng.between(SHORTEST, LONGEST)))
        right = step_right((x, y))
        b = x - right[0], y - right[1]
        if max(x, y) >= SHORTEST and SHORTEST <= max(map(abs, b)) <= LONGEST:
            return (x, y), b


def _points(rng: Rng, a: Point, b: Point, side: int) -> list[Point]:
    """Return 2 or 3 points on one side (1 left, -1 right) of both lines through (0, 0)."""
    found: list[Point] = []
    count = rng.between(2, 3)
    while len(found) < count:
        point = rng.between(-LIMIT, LIMIT), rng.between(-LIMIT, LIMIT)
        if side * cross(a, point) > LIMIT and side * cross(b, point) > LIMIT:
            found.append(point)
    return found
