"""Edges on one line, one behind the other, sharing a point or not.

Attacks segment tests that treat parallel or collinear edges wrongly.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import any_vector, filled
from gen.families.registry import Between, Flag, Length, Move, Scenarios, Vertices, family
from gen.geometry import Point, Polygon, cross, hull, primitive, translated
from gen.rng import Rng
from gen.scenario import Scenario


@family
def in_line(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    reach: Length = 3,
    size: Length = 6,
    most: Annotated[int, Between(3, 1_000)] = 6,
    move: Move = "any",
    corner: Flag = 0,
) -> Iterator[Scenario]:
    """Sweep and obstacle stand on one line, on its two sides, one beyond the other's end.

    Each has an edge or a vertex there. They share a point or more of the line (NO), or the
    next point of the grid lies between them (YES). The move is none, along the line, or away
    from it. reach: size of the line's direction; size: how wide the shapes are.
    """

    def make() -> Scenario:
        along = primitive(any_vector(rng, reach))
        robot = _standing(rng, along, size, most)
        obstacle = [(-x, -y) for x, y in _standing(rng, along, size, most)]
        steps = 0
        away = (0, 0)
        if move == "any" and rng.chance(0.7):
            if rng.chance(0.5):
                steps = rng.between(1, size)
            else:
                away = _beside(rng, along, size)
        # Both shapes end at the origin, the robot at the end of its move along the line.
        gap = rng.choice((1, 1, 1, 2, 0, 0, 0, -1))
        start = translated(robot, (-steps * along[0], -steps * along[1]))
        displacement = steps * along[0] + away[0], steps * along[1] + away[1]
        obstacle = translated(obstacle, (gap * along[0], gap * along[1]))
        return Scenario(start, displacement, [obstacle])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=corner)


def _standing(rng: Rng, along: Point, size: int, most: int) -> Polygon:
    """Return a polygon on the left of the line `along`, or on it, whose last point there is 0.

    Every other one is no wider (no higher, if `along` is upright) than its edge there.
    """
    steps = rng.below(4)
    end = -steps * along[0], -steps * along[1]
    axis = 0 if along[0] else 1
    narrow = steps * abs(along[axis]) > 1 and rng.chance(0.5)
    low, high = sorted((end[axis], 0))
    while True:
        points = [_beside(rng, along, size) for _ in range(rng.between(2, most))]
        if narrow:
            points = [point for point in points if low < point[axis] < high]
        points += [(0, 0), end]
        ring = hull(points)
        if 3 <= len(ring) <= most:
            return ring


def _beside(rng: Rng, along: Point, size: int) -> Point:
    """Return a point on the left of the line through the origin."""
    while True:
        point = any_vector(rng, size)
        side = cross(along, point)
        if side:
            return point if side > 0 else (-point[0], -point[1])
