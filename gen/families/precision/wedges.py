"""Two edges as wide as the world with almost the same slope, leaving one point.

Attacks slopes in extended precision: these differ by less than 2^-55.
"""

from __future__ import annotations

from collections.abc import Iterator

from gen.families.common import filled
from gen.families.registry import Scenarios, Vertices, family
from gen.geometry import hull, primitive, step_right, translated
from gen.rng import Rng
from gen.scenario import LIMIT, Scenario

NARROWEST = 199 * LIMIT // 100  # of two edges nearly as wide as the world


@family
def wedges(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
) -> Iterator[Scenario]:
    """Two edges as wide as the world leave one point in almost the same direction.

    Between the robot's edge and the obstacle's there is no other point of the grid: their
    slopes differ by less than 2^-55. They touch in the corner (NO), or the obstacle is one
    unit higher (YES). Nothing moves.
    """

    def make() -> Scenario | None:
        lower = primitive((rng.between(NARROWEST, 2 * LIMIT), rng.between(-LIMIT, LIMIT)))
        if lower[0] < NARROWEST:
            return None
        right = step_right(lower)  # cross(lower, right) == -1
        upper = lower[0] - right[0], lower[1] - right[1]
        if not NARROWEST <= upper[0] <= 2 * LIMIT:
            return None
        height = rng.between(1, LIMIT // 2)
        below = rng.between(1, lower[0]), min(0, lower[1]) - height
        above = rng.between(1, upper[0]), max(0, upper[1]) + height
        obstacle = translated(hull([(0, 0), upper, above]), (0, rng.below(2)))
        return Scenario(hull([(0, 0), lower, below]), (0, 0), [obstacle])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=True)
