"""The obstacle has the robot's own shape.

Attacks programs that recognise shapes by their form, or skip what they take for the robot.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import any_vector, filled
from gen.families.registry import Between, Far, Length, Scenarios, Vertices, family
from gen.geometry import sweep, translated
from gen.geometry.contact import edge_support, pair
from gen.rng import Rng
from gen.scenario import Scenario
from gen.shapes.convex import in_box


@family
def twins(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    reach: Length = 12,
    far: Far = 12,
    most: Annotated[int, Between(3, 1_000)] = 9,
) -> Iterator[Scenario]:
    """The obstacle equals the robot: at its start or end, on the way, or beside it by one unit.

    Programs fail that recognise shapes by their form, or skip what they take for the robot.
    """

    def make() -> Scenario:
        robot = in_box(rng, reach, rng.between(3, most))
        move = any_vector(rng, far) if far and rng.chance(0.7) else (0, 0)
        if rng.chance(0.4):
            return Scenario(robot, move, [translated(robot, rng.choice(((0, 0), move)))])
        covered = sweep(robot, move)
        support = edge_support(covered, rng.below(len(covered.vertices)))
        placed = pair(rng, support, robot, flat=0)
        return Scenario(robot, move, [placed.missing if rng.chance(0.8) else placed.touching])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=False)
