"""A short edge just beyond the end of a very long one, almost on its line.

Attacks inexact tests of three points almost on a line, and bisections by angle.
"""

from __future__ import annotations

from collections.abc import Iterator

from gen.families.common import any_vector, filled
from gen.families.precision.points import point_beside
from gen.families.registry import Move, Scenarios, Vertices, family
from gen.geometry import Point, cross, hull, primitive, step_right, translated
from gen.rng import Rng
from gen.scenario import LIMIT, Scenario


@family
def beyond(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """A short edge stands beyond the tip of one as wide as the world, almost on its line.

    In their Minkowski sum the two edges follow each other with a cross product of one. The
    short edge reaches the tip (NO), or the next point of the grid lies between (YES). The
    move, if any, leads along the long edge to that place.
    """

    def make() -> Scenario | None:
        steps = rng.between(1, 3)
        short = primitive(any_vector(rng, rng.choice((1, 5, 50))))
        right = step_right(short)
        most = (LIMIT + rng.below(LIMIT - 1_000)) // max(map(abs, short))
        side = rng.choice((1, -1))  # cross(edge, short) == -side
        edge = most * short[0] - side * right[0], most * short[1] - side * right[1]
        far_side = [point_beside(rng, primitive(edge), 1) for _ in range(rng.between(1, 2))]
        robot = hull([(0, 0), edge, *far_side])
        own = steps * short[0], steps * short[1]
        little = hull([(0, 0), own, _near(rng, own)])
        if min(len(robot), len(little)) < 3:
            return None
        gap = rng.choice((1, 1, 1, 2, 0, 0, -1))
        # The obstacle's edge runs back from here, its interior on the other side of the line.
        (tip_x, tip_y), away = rng.choice((((0, 0), -gap), (edge, steps + gap)))
        to_x = tip_x + away * short[0] + rng.choice((0, 0, 0, 0, 1, -1))
        to_y = tip_y + away * short[1]
        obstacle = [(to_x - x, to_y - y) for x, y in little]
        if rng.chance(0.3):
            robot, obstacle = obstacle, robot
        step = (0, 0) if move == "zero" or rng.chance(0.5) else rng.choice((own, edge))
        return Scenario(translated(robot, (-step[0], -step[1])), step, [obstacle])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=True)


def _near(rng: Rng, edge: Point) -> Point:
    """Return a point on the left of the edge, some hundred units away at most."""
    while True:
        point = any_vector(rng, 300)
        if cross(edge, point) > 0:
            return point
