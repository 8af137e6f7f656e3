"""The flattest corner that the grid permits, touched or missed by one unit.

Attacks a convex hull or a turn test that rounds: it loses the corner.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import gcd

from gen.families.common import filled
from gen.families.precision.points import WIDTH
from gen.families.registry import Move, Scenarios, Vertices, family
from gen.geometry import Point, hull, primitive, step_right, translated
from gen.rng import Rng
from gen.scenario import LIMIT, Scenario


@family
def flats(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """The flattest corner of two edges of about 10^8 is touched, or missed by one unit.

    Its edges are the robot's, or the robot's and the move. Their cross product of one is the
    difference of two products beyond 2^53, so a hull that rounds loses the corner.
    """

    def make() -> Scenario | None:
        first, second = _flat_corner(rng)
        still = move == "zero" or rng.chance(0.6)
        back = -first[0], -first[1]
        above = [
            (rng.between(back[0], second[0] if still else 0), rng.between(0, WIDTH - first[1]))
            for _ in range(rng.between(1, 2))
        ]
        robot = hull([back, (0, 0), *([second] if still else []), *above])
        below = [
            (rng.between(back[0], second[0]), rng.between(-WIDTH + second[1], -first[1]))
            for _ in range(2)
        ]
        side: list[Point] = []
        if rng.chance(0.3):  # an edge along one of the two as well
            side = [rng.choice((first, (-second[0], -second[1])))]
        obstacle = hull([(0, 0), *side, *below])
        if min(len(robot), len(obstacle)) < 3 or (0, 0) not in robot or (0, 0) not in obstacle:
            return None
        right = step_right(primitive(first))
        gap = rng.choice(((0, 0), (0, 0), first, back, (-second[0], -second[1]), right))
        obstacle = translated(obstacle, gap)
        if still and rng.chance(0.5):
            robot, obstacle = obstacle, robot
        return Scenario(robot, (0, 0) if still else second, [obstacle])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=True)


def _flat_corner(rng: Rng) -> tuple[Point, Point]:
    """Return two vectors of nearly (10^8, 10^8) with cross product 1."""
    low = 96 * LIMIT // 100
    while True:
        x, y = rng.between(low, LIMIT), rng.between(low, LIMIT)
        if gcd(x, y) == 1:
            right = step_right((x, y))
            second = x - right[0], y - right[1]
            if min(second) >= low:
                return (x, y), second
