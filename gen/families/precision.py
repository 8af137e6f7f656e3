"""Scenes as wide as the world, where products of coordinates differ by one in 10^16."""

from __future__ import annotations

from collections.abc import Iterator
from math import gcd
from typing import Annotated

from gen.families.common import filled
from gen.families.registry import OneOf, Scenarios, Vertices, family
from gen.geometry import Point, Polygon, cross, hull, minus, step_right, sweep, translated
from gen.geometry.contact import edge_support
from gen.rng import Rng
from gen.scenario import LIMIT, Scenario
from gen.shapes.convex import in_box

WIDTH = 2 * LIMIT


@family
def across(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Annotated[str, OneOf(("any", "zero"))] = "any",
) -> Iterator[Scenario]:
    """Robot or sweep has an edge from one end of the world to the other; one unit decides.

    An obstacle's vertex touches that edge, or lies on the next lattice line; its other
    vertices are far away. Robot and obstacle may change roles when nothing moves.
    """

    def make() -> Scenario:
        return _still(rng) if move == "zero" or rng.chance(0.3) else _moving(rng)

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=True)


@family
def diagonal(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Annotated[str, OneOf(("any", "zero"))] = "any",
) -> Iterator[Scenario]:
    """Robot or sweep has an edge along almost the whole diagonal of the world, met in its middle.

    An obstacle has its edge along it, as long, or a vertex near its middle: on the same
    line, one lattice line apart, or one too far inside. There the products of
    coordinates are largest, more than 2^53, and differ by one to six.
    """

    def make() -> Scenario | None:
        steps = rng.between(1, 3)
        along = _diagonal_step(rng, steps)
        side = rng.choice((-1, -1, -1, 0, 1))  # misses fit the world less often
        far_points = [_beyond(rng, along, (0, 0), -1) for _ in range(rng.between(1, 3))]
        place = rng.choice((_facing, _middle))
        near = place(along, steps, side)
        if not near:
            return None
        obstacle = hull([*near, *far_points])
        # The sweep's edge is as long as the robot's own and the move together.
        own = steps if move == "zero" else rng.between(1, steps)
        behind = [_beyond(rng, along, (0, 0), 1) for _ in range(rng.between(1, 3))]
        robot = hull([(0, 0), (own * along[0], own * along[1]), *behind])
        if len(obstacle) < 3 or len(robot) < 3:
            return None
        if own == steps and rng.chance(0.5):
            robot, obstacle = obstacle, robot
        return Scenario(robot, ((steps - own) * along[0], (steps - own) * along[1]), [obstacle])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=True)


def _diagonal_step(rng: Rng, steps: int) -> Point:
    """Return a primitive vector that `steps` times is almost as wide and high as the world."""
    most = WIDTH // steps
    while True:
        x, y = rng.between(96 * most // 100, most), rng.between(96 * most // 100, most)
        if gcd(x, y) == 1:
            return x, y


def _facing(along: Point, steps: int, side: int) -> list[Point]:
    """Return an edge of so many steps on the same line, or on the next on a side (-1 right).

    Few of them fit the world beside the diagonal; [] if this one does not.
    """
    right = step_right(along)
    nearer = min(right, minus(right, along), key=lambda v: abs(v[0]))
    x, y = -side * nearer[0], -side * nearer[1]
    if max(abs(x), abs(y)) > 4 * WIDTH // 100:
        return []
    return [(x, y), (x + steps * along[0], y + steps * along[1])]


def _middle(along: Point, steps: int, side: int) -> list[Point]:
    """Return a point about halfway along `steps` steps, on the line or next to it; [] if none."""
    right = step_right(along)
    offset = (-side * right[0], -side * right[1])
    for i in range(-1, steps + 1):
        x, y = i * along[0] + offset[0], i * along[1] + offset[1]
        if 35 * steps <= 100 * x // along[0] <= 65 * steps:
            return [(x, y)]
    return []


def _long_edge(rng: Rng) -> tuple[Point, int]:
    """Return a primitive direction and how often it fits the world, at least three quarters."""
    times = rng.choice((1, 1, 2, 3, 5))
    most = (WIDTH - 2_000) // times
    while True:
        x, y = rng.between(3 * most // 4, most), rng.between(3 * most // 4, most)
        if gcd(x, y) == 1:
            return (x, y), times


def _beyond(rng: Rng, along: Point, base: Point, side: int) -> Point:
    """Return a random point of the world on a side (1 left, -1 right) of a line, not near it."""
    while True:
        point = rng.between(0, WIDTH), rng.between(0, WIDTH)
        if side * cross(along, minus(point, base)) > WIDTH:
            return point


def _obstacle(rng: Rng, along: Point, base: Point, times: int) -> Polygon:
    """Return a triangle on the right of the line that touches it, or misses it by one unit."""
    s = rng.between(0, times)
    x, y = base[0] + s * along[0], base[1] + s * along[1]
    if rng.chance(0.5):
        right = step_right(along)
        s -= s == times and times > 0  # one step back: the next line's point is beside the edge
        x, y = base[0] + s * along[0] + right[0], base[1] + s * along[1] + right[1]
    while True:
        corners = hull([(x, y), *(_beyond(rng, along, base, -1) for _ in range(rng.between(2, 4)))])
        if len(corners) >= 3:
            return corners


def _still(rng: Rng) -> Scenario:
    along, times = _long_edge(rng)
    end = times * along[0], times * along[1]
    behind = [_beyond(rng, along, (0, 0), 1) for _ in range(rng.between(1, 4))]
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
