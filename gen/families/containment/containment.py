"""One polygon strictly inside the other, or just beside it.

Attacks programs that look for edges that cross, or for a point of one polygon in the other
but not the reverse: nothing crosses here, and yet the closed sets meet.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import any_move, any_shape, any_vector, filled
from gen.families.registry import Between, Flag, Length, Move, OneOf, Scenarios, Vertices, family
from gen.geometry import Polygon, apart, sweep, translated
from gen.geometry.contact import PLACES, pair, random_support
from gen.rng import Rng
from gen.scenario import Scenario

KINDS = ("in_robot_at_start", "in_robot_at_end", "in_sweep", "robot_in", "robot_leaves")


STATIC_KINDS = ("in_robot_at_start", "robot_in")


TRIES = 40


def strictly_inside(outer: Polygon, inner: Polygon) -> bool:
    """Tell whether every vertex of inner is in the open interior of outer. O(product)."""
    ax, ay = outer[-1]
    for bx, by in outer:
        ex, ey = bx - ax, by - ay
        if any(ex * (y - ay) <= ey * (x - ax) for x, y in inner):
            return False
        ax, ay = bx, by
    return True


def put_inside(rng: Rng, outer: Polygon, inner: Polygon) -> Polygon | None:
    """Return inner translated strictly into outer, None if some tries all fail."""
    xs, ys = [x for x, _ in outer], [y for _, y in outer]
    own_x, own_y = min(x for x, _ in inner), min(y for _, y in inner)
    for _ in range(TRIES):
        by = rng.between(min(xs), max(xs)) - own_x, rng.between(min(ys), max(ys)) - own_y
        candidate = translated(inner, by)
        if strictly_inside(outer, candidate):
            return candidate
    return None


def contained(
    rng: Rng, kind: str, reach: int, size: int, most: int, still: bool
) -> Scenario | None:
    """Return a scene of a kind in KINDS, None if the first shapes do not go together."""
    large, little = any_shape(rng, reach, most), any_shape(rng, size, most)
    move = (0, 0) if still else any_vector(rng, 2 * reach)
    back = -move[0], -move[1]
    if kind == "in_robot_at_start":
        obstacle = put_inside(rng, large, little)
        return Scenario(large, move, [obstacle]) if obstacle else None
    if kind == "in_robot_at_end":
        obstacle = put_inside(rng, large, little)
        return Scenario(translated(large, back), move, [obstacle]) if obstacle else None
    if kind == "in_sweep":
        obstacle = put_inside(rng, sweep(large, move).vertices, little)
        if obstacle is None or not apart(large, obstacle):
            return None
        return (
            Scenario(large, move, [obstacle]) if apart(translated(large, move), obstacle) else None
        )
    if kind == "robot_in":  # all the way
        shorter = (0, 0) if still else any_vector(rng, max(1, size // 2))
        covered = put_inside(rng, large, sweep(little, shorter).vertices)
        if covered is None:
            return None
        # The sweep of the robot that begins at the origin's copy is known up to translation.
        dx = min(x for x, _ in covered) - min(x for x, _ in sweep(little, shorter).vertices)
        dy = min(y for _, y in covered) - min(y for _, y in sweep(little, shorter).vertices)
        return Scenario(translated(little, (dx, dy)), shorter, [large])
    robot = put_inside(rng, large, little)  # robot_leaves
    return Scenario(robot, move, [large]) if robot else None


@family
def containment(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    reach: Length = 20,
    size: Length = 5,
    most: Annotated[int, Between(3, 1_000)] = 7,
    kind: Annotated[str, OneOf(("all", *KINDS))] = "all",
    move: Move = "any",
    corner: Flag = 0,
) -> Iterator[Scenario]:
    """One polygon lies strictly inside the other (NO), or one unit beside it (YES).

    The obstacle lies in the robot at the start or at the end, or in the swept area but in
    neither end; or the robot stays in the obstacle all the way, or leaves it, or (as every
    scene may be run backwards) enters it.
    """
    still = move == "zero"
    kinds = [kind] if kind != "all" else list(STATIC_KINDS if still else KINDS)

    def make() -> Scenario | None:
        if rng.chance(0.5):
            return beside(rng, reach, size, most, still)
        return contained(rng, rng.choice(kinds), reach, size, most, still)

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=corner)


def beside(rng: Rng, reach: int, size: int, most: int, still: bool) -> Scenario:
    """Return a scene with a large and a little polygon that miss each other by one unit."""
    robot, obstacle = any_shape(rng, reach, most), any_shape(rng, size, most)
    if rng.chance(0.5):
        robot, obstacle = obstacle, robot
    displacement = any_move(rng, "zero" if still else "any", reach, robot)
    support = random_support(rng, sweep(robot, displacement), rng.choice(PLACES))
    return Scenario(robot, displacement, [pair(rng, support, obstacle, flat=0).missing])
