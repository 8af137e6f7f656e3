"""Random tiny polygons, many to a file.

Attacks mistakes that nobody thought of: in a small world every special case occurs often.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import filled
from gen.families.registry import Between, Scenarios, Vertices, family
from gen.geometry import translated
from gen.rng import Rng
from gen.scenario import Scenario
from gen.shapes.convex import in_box


@family
def tiny(
    rng: Rng,
    *,
    scenarios: Scenarios = 400,
    vertices: Vertices = 2_000,
    size: Annotated[int, Between(1, 1_000)] = 3,
    far: Annotated[int, Between(0, 1_000)] = 3,
    most: Annotated[int, Between(3, 100)] = 3,
    empty: Annotated[int, Between(0, 100)] = 10,
) -> Iterator[Scenario]:
    """Random polygons in a box of `size`, one obstacle each; `empty` per cent have none."""

    def make() -> Scenario:
        robot = in_box(rng, size, most)
        move = rng.between(-far, far), rng.between(-far, far)
        if rng.below(100) < empty:
            return Scenario(robot, move, [])
        shape = in_box(rng, size, most)
        x, y = rng.between(-far, far), rng.between(-far, far)
        # Around the whole way, not only around its start.
        at = x + rng.between(min(move[0], 0), max(move[0], 0)), y
        return Scenario(robot, move, [translated(shape, at)])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=False)
