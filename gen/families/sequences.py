"""A family about the file as a whole: scenes of every kind and scale one after another."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import any_move, any_shape
from gen.families.contacts import contact_scenes
from gen.families.containment import containment
from gen.families.decoys import decoys
from gen.families.registry import Between, OneOf, Scenarios, Vertices, family
from gen.families.rooms import rooms
from gen.families.scenes import random_scenes
from gen.rng import Rng
from gen.scenario import Scenario
from gen.shapes.convex import random_convex


@family
def mixture(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Annotated[str, OneOf(("any", "zero"))] = "any",
    empty: Annotated[int, Between(0, 100)] = 10,
) -> Iterator[Scenario]:
    """Scenes of many families and scales in turn, `empty` per cent of them without obstacles.

    Fills the file to exactly `vertices` (if there may be as many scenarios): the last
    robot, without obstacles, has all that is left.
    """
    still = "zero" if move == "zero" else "mixed"
    moves = {"move": move}
    left = vertices
    for number in range(scenarios):
        one_of = rng.below(100)
        huge = rng.chance(0.3)
        scale = rng.choice((1, 20, 3_000, 2_000_000)) if huge else 1
        wide = {"reach": 12 * scale, "size": 8 * scale, "corner": int(huge), "scenarios": 1}
        if one_of < empty:
            robot = any_shape(rng, 12 * scale, 9)
            made = [Scenario(robot, any_move(rng, still, 20 * scale, robot), [])]
        elif one_of < 40:
            made = list(random_scenes(rng, **wide, far=20 * scale, **moves))
        elif one_of < 60:
            made = [rng.choice(contact_scenes(rng, 12, 20, 8, 7, still, "any", "mixed", 4))]
        elif one_of < 75:
            made = list(decoys(rng, **wide, far=20 * scale, **moves))
        elif one_of < 90:
            made = list(containment(rng, **wide, **moves))
        else:
            made = list(rooms(rng, scenarios=1, corners=7, size=8, robot=3, **moves))
        for scenario in made:
            if scenario.vertices > left - 3 or number == scenarios - 1:
                yield Scenario(random_convex(rng, left), (0, 0), [])
                return
            left -= scenario.vertices
            yield scenario
