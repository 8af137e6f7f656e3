"""An edge along the diagonal of the world, met near its middle.

Attacks floating-point products, which are largest here: more than 2^53, and they differ by
one to six.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import gcd

from gen.families.common import filled
from gen.families.precision.points import WIDTH, far_point_beside
from gen.families.registry import Move, Scenarios, Vertices, family
from gen.geometry import Point, hull, minus, step_right
from gen.rng import Rng
from gen.scenario import Scenario


@family
def diagonal(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """Robot or sweep has an edge along almost the whole diagonal of the world, met in its middle.

    An obstacle has an edge of the same length beside it, or a vertex near its middle: on the
    same line, one lattice line apart, or one too far inside. Products of coordinates are
    largest there, more than 2^53, and differ by one to six.
    """

    def make() -> Scenario | None:
        steps = rng.between(1, 3)
        along = _diagonal_step(rng, steps)
        side = rng.choice((-1, -1, -1, 0, 1))  # misses fit the world less often
        far_points = [far_point_beside(rng, along, (0, 0), -1) for _ in range(rng.between(1, 3))]
        place = rng.choice((_facing, _middle))
        near = place(along, steps, side)
        if not near:
            return None
        obstacle = hull([*near, *far_points])
        # The sweep's edge is as long as the robot's own and the move together.
        own = steps if move == "zero" else rng.between(1, steps)
        behind = [far_point_beside(rng, along, (0, 0), 1) for _ in range(rng.between(1, 3))]
        robot = hull([(0, 0), (own * along[0], own * along[1]), *behind])
        if len(obstacle) < 3 or len(robot) < 3:
            return None
        if own == steps and rng.chance(0.5):
            robot, obstacle = obstacle, robot
        return Scenario(robot, ((steps - own) * along[0], (steps - own) * along[1]), [obstacle])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=True)


def _diagonal_step(rng: Rng, steps: int) -> Point:
    """Return a primitive vector that `steps` times is almost as wide and high as the world."""
    most = WIDTH // steps
    while True:
        x, y = rng.between(96 * most // 100, most), rng.between(96 * most // 100, most)
        if gcd(x, y) == 1:
            return x, y


def _facing(along: Point, steps: int, side: int) -> list[Point]:
    """Return an edge of so many steps on the same line, or on the next on a side (-1 right).

    Few of them fit the world beside the diagonal; [] if this one does not.
    """
    right = step_right(along)
    nearer = min(right, minus(right, along), key=lambda v: abs(v[0]))
    x, y = -side * nearer[0], -side * nearer[1]
    if max(abs(x), abs(y)) > 4 * WIDTH // 100:
        return []
    return [(x, y), (x + steps * along[0], y + steps * along[1])]


def _middle(along: Point, steps: int, side: int) -> list[Point]:
    """Return a point about halfway along `steps` steps, on the line or next to it; [] if none."""
    right = step_right(along)
    offset = (-side * right[0], -side * right[1])
    for i in range(-1, steps + 1):
        x, y = i * along[0] + offset[0], i * along[1] + offset[1]
        if 35 * steps <= 100 * x // along[0] <= 65 * steps:
            return [(x, y)]
    return []
