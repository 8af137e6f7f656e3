"""One edge from one end of the world to the other, and a vertex on it or one unit beside it.

Attacks floating-point and 32-bit products: those of coordinates differ by one in 10^16.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import gcd

from gen.families.common import filled
from gen.families.precision.points import WIDTH, far_point_beside
from gen.families.registry import Move, Scenarios, Vertices, family
from gen.geometry import Point, Polygon, hull, step_right, sweep, translated
from gen.geometry.contact import edge_support
from gen.rng import Rng
from gen.scenario import Scenario
from gen.shapes.convex import in_box


@family
def across(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """Robot or sweep has an edge from one end of the world to the other; one unit decides.

    An obstacle's vertex touches that edge, or lies on the next lattice line; its other
    vertices are far away. Robot and obstacle may swap roles when nothing moves.
    """

    def make() -> Scenario:
        return _still(rng) if move == "zero" or rng.chance(0.3) else _moving(rng)

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=True)


def _long_edge(rng: Rng) -> tuple[Point, int]:
    """Return a primitive direction and how often it fits the world, at least three quarters."""
    times = rng.choice((1, 1, 2, 3, 5))
    most = (WIDTH - 2_000) // times
    while True:
        x, y = rng.between(3 * most // 4, most), rng.between(3 * most // 4, most)
        if gcd(x, y) == 1:
            return (x, y), times


def _obstacle(rng: Rng, along: Point, base: Point, times: int) -> Polygon:
    """Return a triangle on the right of the line that touches it, or misses it by one unit."""
    s = rng.between(0, times)
    x, y = base[0] + s * along[0], base[1] + s * along[1]
    if rng.chance(0.5):
        right = step_right(along)
        s -= s == times and times > 0  # one step back: the next line's point is beside the edge
        x, y = base[0] + s * along[0] + right[0], base[1] + s * along[1] + right[1]
    while True:
        corners = hull(
            [(x, y), *(far_point_beside(rng, along, base, -1) for _ in range(rng.between(2, 4)))]
        )
        if len(corners) >= 3:
            return corners


def _still(rng: Rng) -> Scenario:
    along, times = _long_edge(rng)
    end = times * along[0], times * along[1]
    behind = [far_point_beside(rng, along, (0, 0), 1) for _ in range(rng.between(1, 4))]
    robot = hull([(0, 0), end, *behind])
    obstacle = _obstacle(rng, along, (0, 0), times)
    if rng.chance(0.5):
        robot, obstacle = obstacle, robot
    return Scenario(robot, (0, 0), [obstacle])


def _moving(rng: Rng) -> Scenario:
    along, times = _long_edge(rng)
    move = times * along[0], times * along[1]
    robot = in_box(rng, rng.choice((1, 10, 1_000)), rng.between(3, 8))
    covered = sweep(robot, move)
    side = edge_support(covered, covered.front - 1)
    robot = translated(robot, (-side.base[0], -side.base[1]))
    return Scenario(robot, move, [_obstacle(rng, along, (0, 0), times)])
