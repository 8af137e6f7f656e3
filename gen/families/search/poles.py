"""Contacts beside the outermost vertices of a large polygon.

Attacks walks and bisections along the edges, which begin and end there.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import Robot, any_vector, big_robot
from gen.families.registry import (
    FamilyError,
    Far,
    OneOf,
    Scenarios,
    Vertices,
    family,
)
from gen.geometry import Point, sweep
from gen.geometry.contact import edge_support, pair
from gen.rng import Rng
from gen.scenario import Scenario, disguised, fits, into_corner
from gen.shapes.convex import in_box


@family
def poles(
    rng: Rng,
    *,
    scenarios: Scenarios = 3,
    m: Vertices = 600,
    far: Far = 20,
    robot: Robot = "circle",
    pole: Annotated[str, OneOf(("any", "lowest"))] = "any",
) -> Iterator[Scenario]:
    """A large polygon is touched, or missed by one unit, beside its outermost vertices.

    Contacts are at the two edges before and after its lowest, highest, leftmost or rightmost
    vertex, where walks along the edges begin and end. Some edges are several lattice steps
    long and are touched in between. In every third scene nothing moves, and the large
    polygon is the obstacle.
    """

    def make(number: int) -> Scenario:
        scale = rng.choice((1, 1, 2, 4))
        large = [(scale * x, scale * y) for x, y in big_robot(rng, robot, m)]
        still = far == 0 or number % 3 == 0
        move = (0, 0) if still else any_vector(rng, far)
        covered = sweep(large, move)
        n = len(covered.vertices)
        up = (0, 1) if pole == "lowest" else rng.choice(((0, 1), (0, -1), (1, 0), (-1, 0)))
        lowest = min(range(n), key=lambda i: (_along(covered.vertices[i], up), covered.vertices[i]))
        support = edge_support(covered, (lowest + rng.between(-2, 1)) % n)
        placed = pair(rng, support, in_box(rng, rng.choice((3, 30)), 3), flat=0)
        little = placed.touching if rng.chance(0.5) else placed.missing
        if number % 3 == 0:
            return Scenario(little, (0, 0), [large])
        return Scenario(large, move, [little])

    for number in range(scenarios):
        made = make(number)
        scenario = disguised(rng, made) if pole == "any" else made
        if not fits(scenario):
            raise FamilyError("family poles: no scene fits the world; make m or far smaller")
        yield into_corner(rng, scenario)


def _along(point: Point, direction: Point) -> int:
    return point[0] * direction[0] + point[1] * direction[1]
