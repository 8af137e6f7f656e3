"""Two needles that are beside each other for a tiny part of a long move.

Attacks programs that compute the moment of contact, or step along the move, in floating point.
"""

from __future__ import annotations

from collections.abc import Iterator

from gen.families.common import any_vector, filled
from gen.families.precision.points import WIDTH
from gen.families.registry import Scenarios, Vertices, family
from gen.geometry import Point, cross, hull, primitive, step_right, translated
from gen.rng import Rng
from gen.scenario import LIMIT, Scenario


@family
def passing(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
) -> Iterator[Scenario]:
    """On a long move, the robot's tip passes an obstacle's, one lattice line away (YES), or not.

    Both are needles square to the move. They are beside each other for 10^-8 of the move or
    less, so a program that rounds times or points on the way misses it.
    """

    def make() -> Scenario | None:
        far = rng.choice((LIMIT // 10, LIMIT, WIDTH - 10_000))
        times = rng.choice((1, 1, 2, 7))
        along = primitive(any_vector(rng, far // times))
        if rng.chance(0.3):
            along = rng.choice(((far // times, 1), (1, 0), (far // times, far // times - 1)))
            times = times if max(along) > 1 else far
        length = rng.choice((100, 10_000, 1_000_000, 10_000_000))
        scale = max(map(abs, along))
        square = -along[1] * length // scale, along[0] * length // scale  # to the left
        robot = hull([(0, 0), *_tip(rng, along, square, -1)])
        obstacle = hull([(0, 0), *_tip(rng, along, square, 1)])
        lines = [cross(along, vertex) for vertex in robot], [cross(along, v) for v in obstacle]
        if min(len(robot), len(obstacle)) < 3 or max(lines[0]) != 0 or min(lines[1]) != 0:
            return None
        right = step_right(along)
        apart = rng.choice((1, 1, 1, 0, 0, -1))
        place = rng.between(0, times)
        to_x = place * along[0] - apart * right[0]
        to_y = place * along[1] - apart * right[1]
        displacement = times * along[0], times * along[1]
        return Scenario(robot, displacement, [translated(obstacle, (to_x, to_y))])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=True)


def _tip(rng: Rng, along: Point, square: Point, side: int) -> list[Point]:
    """Return two or three points behind a tip at the origin: on the left (1) or right (-1)."""
    scale = max(map(abs, along))
    wide = rng.choice((1, 2, 5, 1 + max(map(abs, square)) // 10_000))
    found = []
    for _ in range(rng.between(2, 3)):
        percent, lean = rng.between(20, 100), rng.between(-wide, wide)
        found.append(
            (
                side * square[0] * percent // 100 + lean * along[0] // scale + rng.below(2),
                side * square[1] * percent // 100 + lean * along[1] // scale + rng.below(2),
            )
        )
    return found
