"""Complete small worlds.

Attacks mistakes that nobody thought of: nothing small is left out.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice, product
from typing import Annotated

from gen.families.registry import Between, OneOf, Scenarios, Vertices, family
from gen.geometry import Point, Polygon, translated
from gen.rng import Rng
from gen.scenario import Scenario, disguised, moved
from gen.shapes.grids import grid_polygons


def shapes_of(grid: int) -> list[Polygon]:
    """Return every strictly convex polygon in [0, grid]^2 up to translation, sorted.

    Each is pushed to the axes; grid 1: 5 of them, 2: 119.
    """
    return sorted(
        polygon
        for polygon in grid_polygons(grid + 1)
        if min(x for x, _ in polygon) == 0 and min(y for _, y in polygon) == 0
    )


@family
def world(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 500_000,
    grid: Annotated[int, Between(1, 2)] = 1,
    far: Annotated[int, Between(0, 4)] = 2,
    order: Annotated[str, OneOf(("all", "random"))] = "all",
) -> Iterator[Scenario]:
    """A complete small world, or random different scenes of it, one obstacle each.

    Every pair of strictly convex polygons in a box of `grid`, up to translation; every move
    with |dx|, |dy| <= far; every place of the obstacle where its bounding box meets that of
    the sweep. A random symmetry of the grid is applied to each scene. order all: one after
    the other, as many as fit; random: a random selection.
    """
    shapes = shapes_of(grid)
    moves = [(dx, dy) for dx in range(-far, far + 1) for dy in range(-far, far + 1)]
    scenes = _every(shapes, moves) if order == "all" else _random(rng, shapes, moves)
    for scenario in islice(scenes, scenarios):
        vertices -= scenario.vertices
        if vertices < 0:
            return
        yield moved(disguised(rng, scenario), (0, 0))


def _every(shapes: list[Polygon], moves: list[Point]) -> Iterator[Scenario]:
    for robot, obstacle, move in product(shapes, shapes, moves):
        for at in product(*_places(robot, obstacle, move)):
            yield Scenario(robot, move, [translated(obstacle, at)])


def _random(rng: Rng, shapes: list[Polygon], moves: list[Point]) -> Iterator[Scenario]:
    while True:
        robot, obstacle, move = rng.choice(shapes), rng.choice(shapes), rng.choice(moves)
        columns, rows = _places(robot, obstacle, move)
        at = rng.choice(columns), rng.choice(rows)
        yield Scenario(robot, move, [translated(obstacle, at)])


def _places(robot: Polygon, obstacle: Polygon, move: Point) -> tuple[range, range]:
    """Return the obstacle's translations, by axis, at which its box meets the sweep's."""
    columns, rows = (
        range(
            min(delta, 0) - max(vertex[axis] for vertex in obstacle),
            max(delta, 0) + max(vertex[axis] for vertex in robot) + 1,
        )
        for axis, delta in enumerate(move)
    )
    return columns, rows
