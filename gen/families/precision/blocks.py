"""Boxes whose sides are multiples of 2^15 to 2^17.

Attacks products in 32 bits, which become zero here.
"""

from __future__ import annotations

from collections.abc import Iterator

from gen.families.common import filled
from gen.families.registry import Move, Scenarios, Vertices, family
from gen.geometry import translated
from gen.rng import Rng
from gen.scenario import Scenario
from gen.shapes.convex import box


@family
def blocks(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """Boxes with sides of multiples of 2^15 to 2^17 touch in a corner or a side, or do not.

    Products of their sides are multiples of 2^32, which are zero in 32 bits.
    """

    def make() -> Scenario:
        unit = 1 << rng.between(15, 17)
        width, height = rng.between(1, 6) * unit, rng.between(1, 6) * unit
        robot = box(rng.between(1, 6) * unit, rng.between(1, 6) * unit)
        obstacle = box(width, height)
        x = rng.choice((-width, -width, robot[2][0], rng.between(-width, robot[2][0])))
        y = rng.choice((-height, -height, robot[2][1], rng.between(-height, robot[2][1])))
        x += rng.choice((0, 0, -1 if x < 0 else 1))
        y += rng.choice((0, 0, -1 if y < 0 else 1))
        step = (0, 0)
        if move == "any" and rng.chance(0.6):
            step = rng.between(-9, 9) * unit, rng.choice((0, rng.between(-9, 9))) * unit
        return Scenario(
            translated(robot, (-step[0], -step[1])), step, [translated(obstacle, (x, y))]
        )

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=False)
