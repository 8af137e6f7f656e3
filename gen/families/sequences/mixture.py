"""Scenes of many families, scales and sizes in one file.

Attacks state that is carried from one scenario to the next, and arrays sized for the first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Annotated

from gen.families.common import any_move, any_shape
from gen.families.containment.containment import containment
from gen.families.containment.cuts import cuts
from gen.families.precision.across import across
from gen.families.precision.diagonal import diagonal
from gen.families.precision.slivers import slivers
from gen.families.registry import Between, Move, Scenarios, Vertices, family
from gen.families.shortcuts.decoys import decoys
from gen.families.size.hugging import hugging
from gen.families.touching.contacts import contacts
from gen.families.touching.parallel import parallel
from gen.families.unforeseen.random_scenes import random_scenes
from gen.families.unforeseen.rooms import rooms
from gen.families.unforeseen.tiny import tiny
from gen.rng import Rng
from gen.scenario import Scenario
from gen.shapes.convex import random_convex

SCALES = (1, 20, 3_000, 2_000_000)  # a robot of about 12, an obstacle of about 8 of these


@family
def mixture(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
    empty: Annotated[int, Between(0, 100)] = 10,
) -> Iterator[Scenario]:
    """Scenes of many families and scales in turn, `empty` per cent of them without obstacles.

    The larger the file, the larger its largest scenes, up to some 500 vertices. The last
    robot, without obstacles, fills the file to exactly `vertices`, if there may be as many
    scenarios.
    """
    makers = _makers(rng, vertices, move)
    left = vertices
    for number in range(scenarios):
        if rng.below(100) < empty:
            scale = rng.choice(SCALES)
            robot = any_shape(rng, 12 * scale, 9)
            still = "zero" if move == "zero" else "mixed"
            made: Iterable[Scenario] = [
                Scenario(robot, any_move(rng, still, 20 * scale, robot), [])
            ]
        else:
            made = rng.choice(makers)()
        for scenario in made:
            if scenario.vertices > left - 3 or number == scenarios - 1:
                yield Scenario(random_convex(rng, left), (0, 0), [])
                return
            left -= scenario.vertices
            yield scenario


def _makers(rng: Rng, vertices: int, move: str) -> list[Callable[[], Iterable[Scenario]]]:
    """Return functions that make one scene each; some come twice, to be chosen more often."""
    most_robot = max(9, min(vertices // 60, 200))
    most_obstacles = max(4, min(vertices // 200, 60))

    def scale() -> int:
        return rng.choice(SCALES) if rng.chance(0.3) else 1

    def still() -> bool:
        return move == "zero" or rng.chance(0.2)

    def one(maker: Callable[..., Iterable[Scenario]]) -> Callable[[], Iterable[Scenario]]:
        return lambda: maker(rng, scenarios=1, move="zero" if still() else "any")

    def scaled(maker: Callable[..., Iterable[Scenario]]) -> Callable[[], Iterable[Scenario]]:
        def make() -> Iterable[Scenario]:
            unit = scale()
            return maker(
                rng,
                scenarios=1,
                move="zero" if still() else "any",
                reach=12 * unit,
                size=8 * unit,
                corner=int(unit > 1),
            )

        return make

    def touching() -> Iterable[Scenario]:
        # The first of two scenes that differ in one obstacle only: either answer.
        unit = scale()
        return contacts(
            rng,
            scenarios=1,
            obstacles=4,
            move="zero" if still() else "mixed",
            reach=12 * unit,
            far=20 * unit,
            size=8 * unit,
            corner=int(unit > 1),
        )

    def cut() -> Iterable[Scenario]:
        return cuts(rng, scenarios=1, reach=40 * scale(), move="zero" if still() else "mixed")

    def hugged() -> Iterable[Scenario]:
        return hugging(
            rng,
            scenarios=1,
            m=rng.between(9, most_robot),
            obstacles=rng.between(2, most_obstacles),
            n=rng.choice((3, 3, 9)),
            far=0 if still() else rng.choice((10, 1_000, 1_000_000)),
            flat=rng.choice((0, 2)),
            deciding=rng.choice(("none", "any")),
        )

    def little() -> Iterable[Scenario]:
        return tiny(rng, scenarios=1, far=0 if still() else 3, empty=0)

    def room() -> Iterable[Scenario]:
        stop = "zero" if still() else "any"
        return rooms(rng, scenarios=1, corners=7, size=8, robot=3, move=stop)

    often = [
        *map(scaled, (random_scenes, decoys, containment)),
        one(parallel),
        touching,
        cut,
        little,
    ]
    return [*often, *often, hugged, room, *map(one, (across, diagonal, slivers))]
