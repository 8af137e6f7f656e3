"""A polygon of many vertices, with a triangle inside, around it, or beside it.

Attacks programs that test for containment with some of the vertices only, or with edges that
cross: no edge meets another, and the polygon is too large to look at every pair.
"""

from __future__ import annotations

from collections.abc import Iterator

from gen.families.common import Robot, any_vector, big_robot, fitting
from gen.families.containment.containment import put_inside
from gen.families.registry import (
    Far,
    Length,
    Scenarios,
    Vertices,
    family,
)
from gen.geometry import Point, Polygon, minus, sweep, translated
from gen.geometry.contact import edge_support, pair
from gen.rng import Rng
from gen.scenario import Scenario, disguised, into_corner
from gen.shapes.convex import in_box

TRIES = 20


@family
def nested(
    rng: Rng,
    *,
    scenarios: Scenarios = 4,
    m: Vertices = 400,
    size: Length = 5,
    far: Far = 5,
    robot: Robot = "circle",
) -> Iterator[Scenario]:
    """A polygon of m vertices has a triangle inside (NO), around (NO), or beside it (YES).

    Robot and obstacle take either role; the move is short, or none. No edge meets another,
    so a program that looks at edges only, or at some of the vertices, sees nothing.
    """
    for number in range(scenarios):

        def make(number: int = number) -> Scenario | None:
            large = big_robot(rng, robot, m)
            move = (0, 0) if far == 0 or rng.chance(0.3) else any_vector(rng, far)
            return _nested(rng, number, large, move, size)

        too_large = "family nested: no triangle fits; make size, m or far smaller"
        yield into_corner(rng, disguised(rng, fitting(make, TRIES, too_large)))


def _nested(rng: Rng, number: int, large: Polygon, move: Point, size: int) -> Scenario | None:
    """Return the scene with this number, None if the triangle is nowhere inside."""
    little = in_box(rng, size, 3)
    if number % 2:
        covered = sweep(large, move)
        support = edge_support(covered, rng.below(len(covered.vertices)))
        return Scenario(large, move, [pair(rng, support, little, flat=0).missing])
    if number % 8 == 4:
        return Scenario(large, move, [_around(sweep(large, move).vertices)])
    if number % 8 == 6:
        return Scenario(_around(large), move, [large])
    inside = put_inside(rng, large, sweep(little, move).vertices)
    if inside is None:
        return None
    if number % 8 == 2:
        return Scenario(large, move, [translated(inside, move)])
    at, own = min(inside), min(sweep(little, move).vertices)
    return Scenario(translated(little, minus(at, own)), move, [large])


def _around(polygon: Polygon) -> Polygon:
    """Return a triangle that has the polygon strictly inside."""
    left, right = min(x for x, _ in polygon), max(x for x, _ in polygon)
    bottom, top = min(y for _, y in polygon), max(y for _, y in polygon)
    x, y = left - 1, bottom - 1
    return [(x, y), (x + 2 * (right - left) + 8, y), (x, y + 2 * (top - bottom) + 8)]
