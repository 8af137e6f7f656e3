"""Robot, move and obstacles share the directions of their edges.

Attacks mergings of edges that treat ties by angle wrongly.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import any_vector, filled
from gen.families.registry import Between, Flag, Length, Move, Scenarios, Vertices, family
from gen.geometry import Point, sweep
from gen.geometry.contact import PLACES, pair, random_support
from gen.rng import Rng
from gen.scenario import Scenario
from gen.shapes.convex import many_gon
from gen.shapes.edges import directions


@family
def parallel(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    bundle: Annotated[int, Between(2, 60)] = 8,
    reach: Annotated[int, Between(1, 10_000)] = 2,
    stretch: Length = 4,
    most: Annotated[int, Between(3, 1_000)] = 10,
    obstacles: Annotated[int, Between(1, 1_000)] = 2,
    move: Move = "any",
    corner: Flag = 0,
) -> Iterator[Scenario]:
    """All edges (but the closing ones) and the move share few directions and their opposites.

    `bundle` directions with coordinates up to `reach` and lengths up to `stretch`. One
    obstacle touches, or all of them miss by one unit.
    """

    def make() -> Scenario:
        halves = _bundle(rng, bundle, reach)
        edges = halves + [(-x, -y) for x, y in halves]
        robot = many_gon(rng, edges, rng.between(3, most), stretch)
        x, y = rng.choice(edges)
        times = 0 if move == "zero" else rng.between(0, 2 * stretch)
        covered = sweep(robot, (x * times, y * times))
        pairs = [
            pair(
                rng,
                random_support(rng, covered, rng.choice(PLACES)),
                many_gon(rng, edges, rng.between(3, most), stretch),
                flat=0,
            )
            for _ in range(rng.between(1, obstacles))
        ]
        placed = [each.missing for each in pairs]
        if rng.chance(0.5):
            placed[0] = pairs[0].touching
        return Scenario(robot, (x * times, y * times), placed)

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=corner)


def _bundle(rng: Rng, count: int, reach: int) -> list[Point]:
    """Return `count` primitive directions, no two parallel; fewer if there are not so many."""
    if reach <= 8:
        halves = [v for v in directions(reach) if v[1] > 0 or (v[1] == 0 and v[0] > 0)]
        return rng.subset(halves, min(count, len(halves)))
    found: dict[Point, None] = {}
    while len(found) < count:
        x, y = any_vector(rng, reach)
        if y > 0:
            found[x, y] = None
    return list(found)
