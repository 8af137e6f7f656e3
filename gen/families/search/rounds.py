"""Near-circles with the shortest edges there are, touching or one unit apart.

Attacks searches by angle among many short edges, and bounding circles.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import any_move, filled
from gen.families.registry import Between, Length, OneOf, Scenarios, Vertices, family
from gen.geometry import Polygon, sweep, translated
from gen.geometry.contact import PLACES, pair, random_support
from gen.rng import Rng
from gen.scenario import Scenario
from gen.shapes.convex import near_circle


@family
def rounds(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    fewest: Annotated[int, Between(4, 200)] = 9,
    most: Annotated[int, Between(4, 200)] = 14,
    far: Length = 12,
    move: Annotated[str, OneOf(("mixed", "zero"))] = "mixed",
) -> Iterator[Scenario]:
    """Small near-circles whose edges are the shortest grid vectors touch, or miss by one unit.

    One in four obstacles instead has a vertex halfway between two opposite robot vertices.
    fewest, most: vertices of each polygon; far: length of the move.
    """

    def shape() -> Polygon:
        return near_circle(rng, rng.between(min(fewest, most), most))

    def make() -> Scenario:
        robot, obstacle = shape(), shape()
        displacement = any_move(rng, move, far, robot)
        if rng.chance(0.25):
            return Scenario(robot, displacement, [_in_the_middle(rng, robot, obstacle)])
        support = random_support(rng, sweep(robot, displacement), rng.choice(PLACES))
        placed = pair(rng, support, obstacle, flat=0)
        chosen = placed.touching if rng.chance(0.33) else placed.missing
        return Scenario(robot, displacement, [chosen])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=False)


def _in_the_middle(rng: Rng, robot: Polygon, obstacle: Polygon) -> Polygon:
    """Return the obstacle with a vertex halfway between two opposite robot vertices."""
    start = rng.below(len(robot))
    ax, ay = robot[start]
    bx, by = robot[(start + len(robot) // 2) % len(robot)]
    x, y = rng.choice(obstacle)
    return translated(obstacle, ((ax + bx) // 2 - x, (ay + by) // 2 - y))
