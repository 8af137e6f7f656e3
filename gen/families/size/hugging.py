"""Obstacles all around the sweep, each one unit away from it, and one that may touch.

Attacks slow methods, and arrays and searches that are too small: no obstacle can be ruled out
by its distance.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import Deciding, Robot, any_vector, big_robot, fitting, turns
from gen.families.registry import (
    Between,
    Far,
    Scenarios,
    Vertices,
    family,
)
from gen.geometry import Polygon, Sweep, step_right, sweep
from gen.geometry.contact import Pair, Support, edge_support, pair, vertex_support
from gen.rng import Rng
from gen.scenario import Disguise, Scenario, disguised, into_corner
from gen.shapes.convex import in_box, near_circle, random_convex

TRIES = 4
LONG = 1_000_000  # no obstacle lies flat along a direction longer than this


def around(rng: Rng, covered: Sweep, count: int) -> list[Support]:
    """Return `count` supporting lines: both sides of the move, then evenly all around."""
    n = len(covered.vertices)
    first = rng.below(n)
    at = [covered.front - 1, n - 1, *((first + i * n // count) % n for i in range(count - 2))]
    return [
        edge_support(covered, i) if rng.chance(0.5) else vertex_support(rng, covered, i)
        for i in at[:count]
    ]


def obstacle_shapes(rng: Rng, n: int, count: int) -> list[Polygon]:
    """Return a stock of up to 32 obstacle shapes with exactly n vertices each."""
    stock = min(count, 32 if n <= 1_000 else 2)
    if n == 3:
        return [in_box(rng, rng.choice((3, 30, 300, 3_000)), 3) for _ in range(stock)]
    return [near_circle(rng, n) if i % 2 else random_convex(rng, n) for i in range(stock)]


def flat_triangle(rng: Rng, support: Support, longest: int) -> Polygon:
    """Return a triangle with an edge of 1 to `longest` lattice steps along the line."""
    (x, y), (right_x, right_y) = support.along, step_right(support.along)
    steps, high, lean = rng.between(1, longest), rng.between(1, 50), rng.between(-3, 3)
    apex = high * right_x + lean * x, high * right_y + lean * y
    return [(0, 0), (-steps * x, -steps * y), apex]


@family
def hugging(
    rng: Rng,
    *,
    scenarios: Scenarios = 2,
    m: Vertices = 100,
    obstacles: Annotated[int, Between(1, 166_665)] = 50,
    n: Vertices = 3,
    far: Far = 1_000,
    robot: Robot = "circle",
    flat: Annotated[int, Between(0, 100_000)] = 0,
    deciding: Deciding = "pairs",
) -> Iterator[Scenario]:
    """Obstacles of n vertices surround the sweep closely; `deciding` tells which one touches.

    Half of them are placed at an edge of the sweep, half at a vertex. With flat >= 1 every
    other one is a triangle that faces the sweep with an edge of up to `flat` lattice steps.
    Everything lies in a corner of the world. far 0: nothing moves. deciding: none; any; the
    last; pairs: none in half of the scenes, any in the other half.
    """
    shapes = obstacle_shapes(rng, n, obstacles)
    for who in turns(rng, deciding, scenarios):

        def make(who: str = who) -> Disguise:
            return _hugged(rng, big_robot(rng, robot, m), obstacles, shapes, far, flat, who)

        too_large = "family hugging: no scene fits the world; make far, m or n smaller"
        yield into_corner(rng, fitting(make, TRIES, too_large))


def _hugged(
    rng: Rng, robot: Polygon, count: int, shapes: list[Polygon], far: int, flat: int, who: str
) -> Disguise:
    move = any_vector(rng, far) if far else (0, 0)
    covered = sweep(robot, move)
    pairs: list[Pair] = []
    for number, support in enumerate(around(rng, covered, count)):
        own = flat > 0 and number % 2 == 1 and max(map(abs, support.along)) < LONG
        shape = flat_triangle(rng, support, flat) if own else rng.choice(shapes)
        pairs.append(pair(rng, support, shape, flat=0))
    rng.shuffle(pairs)
    obstacles = [each.missing for each in pairs]
    if who != "none":
        index = count - 1 if who == "last" else rng.below(count)
        obstacles[index] = pairs[index].touching
    return disguised(rng, Scenario(robot, move, obstacles), reorder=False)
