"""Two long edges whose directions differ by a cross product of one.

Attacks inexact sorting of the edges of a Minkowski sum by angle.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import gcd

from gen.families.common import filled
from gen.families.precision.points import WIDTH, point_beside
from gen.families.registry import Move, Scenarios, Vertices, family
from gen.geometry import Point, hull, minus, step_right, translated
from gen.rng import Rng
from gen.scenario import Scenario


@family
def chords(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """A vertex touches the middle of an edge as wide as the world, or misses it by one unit.

    At that vertex begins an edge of the other shape, or the robot's move, about as long; its
    direction differs by a cross product of one. The answer depends on which of the two comes
    first by angle.
    """

    def make() -> Scenario | None:
        times = rng.choice((1, 2, 2, 3))
        along = _long_direction(rng, WIDTH // times - 5)
        right = step_right(along)
        turns = rng.choice((-1, 0, 0, 1))
        near = turns * along[0] - right[0], turns * along[1] - right[1]  # cross(along, near) == 1
        end = times * along[0], times * along[1]
        obstacle = hull([(0, 0), end, point_beside(rng, along, -1)])
        middle = rng.between(1, max(1, times - 1)) if rng.chance(0.7) else rng.between(0, times)
        vertex = middle * along[0], middle * along[1]
        apex = minus(point_beside(rng, along, 1), vertex)
        still = move == "zero" or rng.chance(0.6)
        third = near if still else (apex[0] // 2 + rng.between(-5, 5), apex[1] // 2)
        robot = hull([(0, 0), apex, third])
        if (0, 0) not in robot or min(len(robot), len(obstacle)) < 3:
            return None
        gap = rng.choice(((0, 0), (0, 0), near, (-right[0], -right[1]), right))
        robot = translated(robot, (vertex[0] + gap[0], vertex[1] + gap[1]))
        if still and rng.chance(0.5):
            robot, obstacle = obstacle, robot
        return Scenario(robot, (0, 0) if still else near, [obstacle])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=True)


def _long_direction(rng: Rng, most: int) -> Point:
    """Return a primitive vector at least half as wide as `most`."""
    low = rng.choice((9 * most // 10, most // 2))
    while True:
        x = rng.between(low, most)
        y = rng.between(rng.choice((0, low)), most) * rng.choice((1, 1, -1))
        if gcd(x, y) == 1:
            return x, y
