"""Slim obstacles that cut through the swept area, all vertices outside of it.

Attacks programs that only ask whether a vertex of one polygon lies in the other.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import MOVES, any_move, any_shape, any_vector, filled
from gen.families.registry import Between, Flag, Length, OneOf, Scenarios, Vertices, family
from gen.geometry import Point, Polygon, cross, hull, primitive, step_right, sweep
from gen.rng import Rng
from gen.scenario import Scenario


@family
def cuts(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    reach: Length = 40,
    far: Length = 40,
    most: Annotated[int, Between(3, 1_000)] = 14,
    move: Annotated[str, OneOf(MOVES)] = "mixed",
    corner: Flag = 0,
) -> Iterator[Scenario]:
    """Slim obstacles cut through the sweep without a vertex inside it, or pass by.

    In half of the scenes one of them cuts, anywhere from the boundary to the middle. In the
    other half all pass by, the nearest one lattice line away. A program sees the difference
    only if it looks at the right edge of the sweep.
    """

    def make() -> Scenario | None:
        robot = any_shape(rng, reach, most)
        displacement = any_move(rng, move, far, robot)
        covered = sweep(robot, displacement).vertices
        meets = [False] * rng.between(1, 2)
        meets[0] = rng.chance(0.55)
        obstacles = [_blade(rng, covered, cutting) for cutting in meets]
        return Scenario(robot, displacement, obstacles)

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=corner)


def _blade(rng: Rng, covered: Polygon, cutting: bool) -> Polygon:
    """Return a long triangle with an edge that crosses the sweep, or misses it.

    That edge reaches from one side of the sweep beyond the other; the third vertex is beyond
    its end.
    """
    x, y = primitive(any_vector(rng, rng.choice((2, 5, 40))))
    right_x, right_y = step_right((x, y))
    levels = [cross((x, y), vertex) for vertex in covered]  # 0 on the line through (0, 0)
    lowest, highest = min(levels), max(levels)
    near = rng.between(0, 3) if rng.chance(0.8) else rng.between(0, highest - lowest)
    level = min(highest, lowest + near) if cutting else lowest - 1 - rng.below(2)
    base = -level * right_x, -level * right_y  # on the line of this level
    steps = [(vx - base[0]) * x + (vy - base[1]) * y for vx, vy in covered]
    square = x * x + y * y
    first, last = min(steps) // square - rng.between(1, 4), -(-max(steps) // square)
    last += rng.between(1, 4)

    def at(step: int, deep: int) -> Point:
        """Return a point so many steps along the line, on a line so much further right."""
        return base[0] + step * x + deep * right_x, base[1] + step * y + deep * right_y

    beyond = last + rng.between(5, 9)  # past any shift along that going right brings
    return hull([at(first, 0), at(last, 0), at(beyond, rng.between(1, 3))])
