"""An obstacle touches the sweep, or misses it by one unit.

Attacks programs that take a touch for free passage, a near miss for a collision, or forget a
part of the sweep's boundary.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import MOVES, any_move, any_shape, filled
from gen.families.registry import Between, Flag, Length, OneOf, Scenarios, Vertices, family
from gen.geometry import Sweep, sweep
from gen.geometry.contact import PLACES, Pair, pair, random_support
from gen.rng import Rng
from gen.scenario import Scenario, fits

FEATURES = ("mixed", "vertex", "edge")


def random_pair(rng: Rng, covered: Sweep, place: str, feature: str, size: int, most: int) -> Pair:
    """Return an obstacle at a random place of the sweep's boundary, touching and missing."""
    support = random_support(rng, covered, rng.choice(PLACES) if place == "any" else place)
    flat = feature == "edge" or (feature == "mixed" and rng.chance(0.5))
    longest = max(map(abs, support.along))
    steps = rng.between(1, max(1, min(size, 2 * size // longest))) if flat else 0
    return pair(rng, support, any_shape(rng, size, most), flat=steps)


def contact_scenes(
    rng: Rng,
    reach: int,
    far: int,
    size: int,
    most: int,
    move: str,
    place: str,
    feature: str,
    k: int,
) -> tuple[Scenario, Scenario]:
    """Return two scenes that differ in one obstacle: it touches; it misses by one unit.

    The other 0 to k - 1 obstacles miss by one unit too.
    """
    robot = any_shape(rng, reach, most)
    displacement = any_move(rng, move, far, robot)
    covered = sweep(robot, displacement)
    pairs = [
        random_pair(rng, covered, place, feature, size, most) for _ in range(rng.between(1, k))
    ]
    missing = [each.missing for each in pairs]
    return (
        Scenario(robot, displacement, [pairs[0].touching, *missing[1:]]),
        Scenario(robot, displacement, missing),
    )


@family
def contacts(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    reach: Length = 12,
    far: Length = 20,
    size: Length = 8,
    most: Annotated[int, Between(3, 1_000)] = 7,
    obstacles: Annotated[int, Between(1, 1_000)] = 3,
    move: Annotated[str, OneOf(MOVES)] = "mixed",
    place: Annotated[str, OneOf(("any", *PLACES))] = "any",
    feature: Annotated[str, OneOf(FEATURES)] = "mixed",
    corner: Flag = 0,
) -> Iterator[Scenario]:
    """Pairs of scenes: one obstacle touches the sweep (NO), or misses it by one unit (YES).

    reach, far, size: how wide the robot is, how long the move, how wide the obstacles;
    corner 1 pushes each scene into a corner of the world.
    """
    waiting: list[Scenario] = []

    def make() -> Scenario | None:
        if not waiting:
            both = contact_scenes(rng, reach, far, size, most, move, place, feature, obstacles)
            if not all(map(fits, both)):
                return None
            waiting.extend(both)
            rng.shuffle(waiting)
        return waiting.pop()

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=corner)
