"""A large polygon and its mirror image touch in one vertex, or are one unit apart.

Attacks separating-axis tests that rely on an early exit: here it almost never comes early.
"""

from __future__ import annotations

from collections.abc import Iterator

from gen.families.common import Robot, big_robot
from gen.families.registry import (
    FamilyError,
    Scenarios,
    Vertices,
    family,
)
from gen.geometry import minus, primitive, step_right
from gen.rng import Rng
from gen.scenario import Scenario, disguised, fits, into_corner


@family
def facing(
    rng: Rng,
    *,
    scenarios: Scenarios = 2,
    m: Vertices = 400,
    robot: Robot = "arc",
) -> Iterator[Scenario]:
    """A polygon and its mirror image touch with one vertex each (NO), or miss by one unit.

    Nothing moves. Few lines separate the two, or none, and no edges meet but at that vertex.
    Edge-by-edge tests with an early exit almost never exit early here.
    """
    for number in range(scenarios):
        shape = big_robot(rng, robot, m)
        middle = m // 2
        x, y = shape[middle]
        gap_x, gap_y = 0, 0
        if number % 2:
            gap_x, gap_y = step_right(primitive(minus(shape[middle + 1], shape[middle - 1])))
        image = [(2 * x - vx + gap_x, 2 * y - vy + gap_y) for vx, vy in shape]
        scenario = disguised(rng, Scenario(shape, (0, 0), [image]))
        if not fits(scenario):
            raise FamilyError("family facing: no scene fits the world; make m smaller")
        yield into_corner(rng, scenario)
