"""Two needles on one line, tip to tip.

Attacks quick tests by bounding circles that round a touch away.
"""

from __future__ import annotations

from collections.abc import Iterator

from gen.families.common import any_vector, filled
from gen.families.registry import Move, Scenarios, Vertices, family
from gen.geometry import Point, Polygon, hull, translated
from gen.rng import Rng
from gen.scenario import LIMIT, Scenario


@family
def tips(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """Two needles on one line touch tip to tip, or are one grid point apart.

    The circles around them touch too, or nearly, so a test by rounded circles is wrong. The
    move, if any, is along the line.
    """

    def make() -> Scenario | None:
        size = rng.choice((3, 10, 1_000, 1_000_000, LIMIT // 4))
        direction = any_vector(rng, size)
        robot = _needle(rng, direction, -rng.between(1, 4))
        obstacle = _needle(rng, direction, rng.between(1, 4))
        if min(len(robot), len(obstacle)) < 3:
            return None
        if rng.chance(0.5):
            x = (direction[0] > 0) - (direction[0] < 0)
            y = (direction[1] > 0) - (direction[1] < 0)
            obstacle = translated(obstacle, rng.choice(((x, y), (x, 0), (0, y))))
        step = (0, 0)
        if move == "any" and rng.chance(0.5):
            times = rng.between(1, 2)
            step = times * direction[0], times * direction[1]
        return Scenario(translated(robot, (-step[0], -step[1])), step, [obstacle])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=False)


def _needle(rng: Rng, direction: Point, times: int) -> Polygon:
    """Return a thin triangle from the origin along so many times a direction.

    Its bounding box is that of the long edge: so the centres of two such are on one line.
    """
    x, y = times * direction[0], times * direction[1]
    wide = rng.choice((1, 1, 2, max(1, max(map(abs, direction)) // 1_000)))
    inward_x = min(abs(x), rng.between(0, wide)) * (-1 if x > 0 else 1)
    inward_y = min(abs(y), rng.between(0, wide)) * (-1 if y > 0 else 1)
    return hull([(0, 0), (x, y), (x + inward_x, y + inward_y)])
