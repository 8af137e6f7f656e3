"""Scattered obstacles, of which one decides or none does.

Attacks loops over the obstacles that stop too early, and mistakes that nobody thought of.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import MOVES, any_move, any_shape, filled
from gen.families.registry import Between, Flag, Length, OneOf, Scenarios, Vertices, family
from gen.geometry import Polygon, apart, sweep, translated
from gen.rng import Rng
from gen.scenario import Scenario


def scattered(
    rng: Rng, around: Polygon, size: int, most: int, count: int, deciding: bool
) -> list[Polygon]:
    """Return obstacles near a convex polygon: one meets it if `deciding`, the others do not.

    O(count * len(around) * most) per round of tries; about two rounds on average.
    """
    xs, ys = [x for x, _ in around], [y for _, y in around]
    low_x, high_x, low_y, high_y = min(xs), max(xs), min(ys), max(ys)
    obstacles: list[Polygon] = []
    margin = size
    while len(obstacles) < count:
        meets = deciding and not obstacles
        shape = any_shape(rng, size, most)
        at = (
            rng.between(low_x - margin, high_x + margin // 2),
            rng.between(low_y - margin, high_y + margin // 2),
        )
        candidate = translated(shape, at)
        if apart(around, candidate) != meets:
            obstacles.append(candidate)
            margin = size
        elif meets:
            margin = margin // 2  # nearer, until it must meet
        else:
            margin += margin // 4 + 1  # further, until it cannot
    return obstacles


@family
def random_scenes(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    reach: Length = 10,
    far: Length = 20,
    size: Length = 10,
    most: Annotated[int, Between(3, 1_000)] = 8,
    obstacles: Annotated[int, Between(0, 10_000)] = 6,
    move: Annotated[str, OneOf(MOVES)] = "mixed",
    corner: Flag = 0,
) -> Iterator[Scenario]:
    """Scattered obstacles: in half of the scenes exactly one of them is met, anywhere in order."""

    def make() -> Scenario:
        robot = any_shape(rng, reach, most)
        displacement = any_move(rng, move, far, robot)
        around = sweep(robot, displacement).vertices
        count = rng.between(0, obstacles)
        met = scattered(rng, around, size, most, count, rng.chance(0.6))
        return Scenario(robot, displacement, met)

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=corner)
