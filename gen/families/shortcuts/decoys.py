"""Obstacles that a wrong idea of the swept area judges wrongly.

Attacks programs that look at both ends of the move only, at the bounding box, at the mirrored
robot, or in the wrong direction.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Annotated

from gen.families.common import any_move, any_shape, filled
from gen.families.registry import Between, Flag, Length, Move, OneOf, Scenarios, Vertices, family
from gen.geometry import Point, Polygon, apart, sweep, translated
from gen.rng import Rng
from gen.scenario import Scenario
from gen.shapes.convex import box

TRIES = 60


def _box(robot: Polygon, move: Point) -> list[Polygon]:
    covered = sweep(robot, move).vertices
    xs, ys = [x for x, _ in covered], [y for _, y in covered]
    return [translated(box(max(xs) - min(xs), max(ys) - min(ys)), (min(xs), min(ys)))]


def _mirrored(robot: Polygon, move: Point) -> list[Polygon]:
    x0, y0 = robot[0]
    return [sweep([(2 * x0 - x, 2 * y0 - y) for x, y in robot], move).vertices]


# What a wrong program takes the robot's sweep for.
IDEAS: dict[str, Callable[[Polygon, Point], list[Polygon]]] = {
    "ends": lambda robot, move: [robot, translated(robot, move)],  # the way is forgotten
    "start": lambda robot, move: [robot],
    "end": lambda robot, move: [translated(robot, move)],
    "behind": lambda robot, move: [sweep(robot, (-move[0], -move[1])).vertices],
    "beyond": lambda robot, move: [sweep(robot, (3 * move[0], 3 * move[1])).vertices],
    "box": _box,
    "mirrored": _mirrored,
    "swapped": lambda robot, move: [sweep(robot, (move[1], move[0])).vertices],
}


STATIC_IDEAS = ("box", "mirrored")


@family
def decoys(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    reach: Length = 10,
    far: Length = 20,
    size: Length = 8,
    most: Annotated[int, Between(3, 1_000)] = 6,
    idea: Annotated[str, OneOf(("all", *IDEAS))] = "all",
    move: Move = "any",
    corner: Flag = 0,
) -> Iterator[Scenario]:
    """One obstacle that a wrong idea of the swept area judges wrongly, with both answers.

    idea: what the wrong program looks at: both ends or one of them; the way back (behind) or
    a longer way (beyond); the bounding box; the mirrored robot; dx and dy swapped.
    """
    ideas = [idea] if idea != "all" else list(STATIC_IDEAS if move == "zero" else IDEAS)

    def make() -> Scenario | None:
        robot = any_shape(rng, reach, most)
        displacement = any_move(rng, move, far, robot)
        covered = sweep(robot, displacement).vertices
        wrong = IDEAS[rng.choice(ideas)](robot, displacement)
        # Some ideas see too much only, or too little only. Then the other answer comes,
        # in the second half of the tries, from a scene that the idea judges rightly.
        meeting = rng.chance(0.5)
        source = covered if meeting else rng.choice(wrong)
        for attempt in range(TRIES):
            shape = any_shape(rng, size, most)
            (x, y), (own_x, own_y) = rng.choice(source), rng.choice(shape)
            by = x - own_x + rng.between(-size, size), y - own_y + rng.between(-size, size)
            obstacle = translated(shape, by)
            seen = any(not apart(area, obstacle) for area in wrong)
            if apart(covered, obstacle) != meeting and (seen != meeting or attempt >= TRIES // 2):
                return Scenario(robot, displacement, [obstacle])
        return None

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=corner)
