"""Few vertices, long edges, and directions as near to each other as the grid permits.

Each family is aimed at one step of a solution that must be exact: a turn that sorts two
edges, a bisection by angle, a hull's test of three points, a moment on the move.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import gcd
from typing import Annotated

from gen.families.common import any_vector, filled
from gen.families.registry import OneOf, Scenarios, Vertices, family
from gen.geometry import Point, Polygon, cross, hull, minus, primitive, step_right, translated
from gen.rng import Rng
from gen.scenario import LIMIT, Scenario
from gen.shapes.convex import box

WIDTH = 2 * LIMIT
Move = Annotated[str, OneOf(("any", "zero"))]


@family
def chords(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """A vertex touches the middle of an edge as wide as the world, or misses it by one unit.

    There the other shape has an edge, or the robot its move, about as long and turned
    away from it by a cross product of one: which of the two comes first decides all.
    """

    def make() -> Scenario | None:
        times = rng.choice((1, 2, 2, 3))
        along = _long_direction(rng, WIDTH // times - 5)
        right = step_right(along)
        turns = rng.choice((-1, 0, 0, 1))
        near = turns * along[0] - right[0], turns * along[1] - right[1]  # cross(along, near) == 1
        end = times * along[0], times * along[1]
        obstacle = hull([(0, 0), end, _inside(rng, along, -1)])
        middle = rng.between(1, max(1, times - 1)) if rng.chance(0.7) else rng.between(0, times)
        vertex = middle * along[0], middle * along[1]
        apex = minus(_inside(rng, along, 1), vertex)
        still = move == "zero" or rng.chance(0.6)
        third = near if still else (apex[0] // 2 + rng.between(-5, 5), apex[1] // 2)
        robot = hull([(0, 0), apex, third])
        if (0, 0) not in robot or min(len(robot), len(obstacle)) < 3:
            return None
        gap = rng.choice(((0, 0), (0, 0), near, (-right[0], -right[1]), right))
        robot = translated(robot, (vertex[0] + gap[0], vertex[1] + gap[1]))
        if still and rng.chance(0.5):
            robot, obstacle = obstacle, robot
        return Scenario(robot, (0, 0) if still else near, [obstacle])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=True)


@family
def flats(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """The flattest corner there is, of two edges of 10^8, is touched or missed by one unit.

    Its edges are the robot's, or the robot's and the move. The cross product of one is
    the difference of two products beyond 2^53: a hull that rounds loses the corner.
    """

    def make() -> Scenario | None:
        first, second = _flat_corner(rng)
        still = move == "zero" or rng.chance(0.6)
        back = -first[0], -first[1]
        above = [
            (rng.between(back[0], second[0] if still else 0), rng.between(0, WIDTH - first[1]))
            for _ in range(rng.between(1, 2))
        ]
        robot = hull([back, (0, 0), *([second] if still else []), *above])
        below = [
            (rng.between(back[0], second[0]), rng.between(-WIDTH + second[1], -first[1]))
            for _ in range(2)
        ]
        side: list[Point] = []
        if rng.chance(0.3):  # an edge along one of the two as well
            side = [rng.choice((first, (-second[0], -second[1])))]
        obstacle = hull([(0, 0), *side, *below])
        if min(len(robot), len(obstacle)) < 3 or (0, 0) not in robot or (0, 0) not in obstacle:
            return None
        right = step_right(primitive(first))
        gap = rng.choice(((0, 0), (0, 0), first, back, (-second[0], -second[1]), right))
        obstacle = translated(obstacle, gap)
        if still and rng.chance(0.5):
            robot, obstacle = obstacle, robot
        return Scenario(robot, (0, 0) if still else second, [obstacle])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=True)


@family
def beyond(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """A short edge stands beyond the tip of one as wide as the world, almost on its line.

    Their sum has the two edges one after the other, with a cross product of one. The
    short one reaches the tip (NO), or the next point of the grid is between (YES). The
    move, if any, leads along the long edge to the place.
    """

    def make() -> Scenario | None:
        steps = rng.between(1, 3)
        short = primitive(any_vector(rng, rng.choice((1, 5, 50))))
        right = step_right(short)
        most = (LIMIT + rng.below(LIMIT - 1_000)) // max(map(abs, short))
        side = rng.choice((1, -1))  # cross(edge, short) == -side
        edge = most * short[0] - side * right[0], most * short[1] - side * right[1]
        far_side = [_inside(rng, primitive(edge), 1) for _ in range(rng.between(1, 2))]
        robot = hull([(0, 0), edge, *far_side])
        own = steps * short[0], steps * short[1]
        little = hull([(0, 0), own, _near(rng, own)])
        if min(len(robot), len(little)) < 3:
            return None
        gap = rng.choice((1, 1, 1, 2, 0, 0, -1))
        # The obstacle's edge runs back from here, its interior on the other side of the line.
        (tip_x, tip_y), away = rng.choice((((0, 0), -gap), (edge, steps + gap)))
        to_x = tip_x + away * short[0] + rng.choice((0, 0, 0, 0, 1, -1))
        to_y = tip_y + away * short[1]
        obstacle = [(to_x - x, to_y - y) for x, y in little]
        if rng.chance(0.3):
            robot, obstacle = obstacle, robot
        step = (0, 0) if move == "zero" or rng.chance(0.5) else rng.choice((own, edge))
        return Scenario(translated(robot, (-step[0], -step[1])), step, [obstacle])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=True)


@family
def passing(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
) -> Iterator[Scenario]:
    """On a long move, the robot's tip passes an obstacle's, one lattice line away (YES), or not.

    Both are needles square to the move: they are beside each other for a moment that is a
    10^-8 part of it or less, so times and points on the way that are rounded miss it.
    """

    def make() -> Scenario | None:
        far = rng.choice((LIMIT // 10, LIMIT, WIDTH - 10_000))
        times = rng.choice((1, 1, 2, 7))
        along = primitive(any_vector(rng, far // times))
        if rng.chance(0.3):
            along = rng.choice(((far // times, 1), (1, 0), (far // times, far // times - 1)))
            times = times if max(along) > 1 else far
        length = rng.choice((100, 10_000, 1_000_000, 10_000_000))
        scale = max(map(abs, along))
        square = -along[1] * length // scale, along[0] * length // scale  # to the left
        robot = hull([(0, 0), *_tip(rng, along, square, -1)])
        obstacle = hull([(0, 0), *_tip(rng, along, square, 1)])
        lines = [cross(along, vertex) for vertex in robot], [cross(along, v) for v in obstacle]
        if min(len(robot), len(obstacle)) < 3 or max(lines[0]) != 0 or min(lines[1]) != 0:
            return None
        right = step_right(along)
        apart = rng.choice((1, 1, 1, 0, 0, -1))
        place = rng.between(0, times)
        to_x = place * along[0] - apart * right[0]
        to_y = place * along[1] - apart * right[1]
        displacement = times * along[0], times * along[1]
        return Scenario(robot, displacement, [translated(obstacle, (to_x, to_y))])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=True)


@family
def tips(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """Two needles on one line touch tip to tip, or are a grid point apart.

    Circles around them touch as well, or nearly: a test that rounds them away is wrong.
    The move, if any, is along the line.
    """

    def make() -> Scenario | None:
        size = rng.choice((3, 10, 1_000, 1_000_000, LIMIT // 4))
        direction = any_vector(rng, size)
        robot = _needle(rng, direction, -rng.between(1, 4))
        obstacle = _needle(rng, direction, rng.between(1, 4))
        if min(len(robot), len(obstacle)) < 3:
            return None
        if rng.chance(0.5):
            x = (direction[0] > 0) - (direction[0] < 0)
            y = (direction[1] > 0) - (direction[1] < 0)
            obstacle = translated(obstacle, rng.choice(((x, y), (x, 0), (0, y))))
        step = (0, 0)
        if move == "any" and rng.chance(0.5):
            times = rng.between(1, 2)
            step = times * direction[0], times * direction[1]
        return Scenario(translated(robot, (-step[0], -step[1])), step, [obstacle])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=False)


@family
def blocks(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """Boxes with sides of multiples of 2^15 to 2^17 touch in a corner or a side, or do not.

    Products of their sides are multiples of 2^32: in 32 bits they are zero.
    """

    def make() -> Scenario:
        unit = 1 << rng.between(15, 17)
        width, height = rng.between(1, 6) * unit, rng.between(1, 6) * unit
        robot = box(rng.between(1, 6) * unit, rng.between(1, 6) * unit)
        obstacle = box(width, height)
        x = rng.choice((-width, -width, robot[2][0], rng.between(-width, robot[2][0])))
        y = rng.choice((-height, -height, robot[2][1], rng.between(-height, robot[2][1])))
        x += rng.choice((0, 0, -1 if x < 0 else 1))
        y += rng.choice((0, 0, -1 if y < 0 else 1))
        step = (0, 0)
        if move == "any" and rng.chance(0.6):
            step = rng.between(-9, 9) * unit, rng.choice((0, rng.between(-9, 9))) * unit
        return Scenario(
            translated(robot, (-step[0], -step[1])), step, [translated(obstacle, (x, y))]
        )

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=False)


def _long_direction(rng: Rng, most: int) -> Point:
    """Return a primitive vector at least half as wide as `most`."""
    low = rng.choice((9 * most // 10, most // 2))
    while True:
        x = rng.between(low, most)
        y = rng.between(rng.choice((0, low)), most) * rng.choice((1, 1, -1))
        if gcd(x, y) == 1:
            return x, y


def _inside(rng: Rng, along: Point, side: int) -> Point:
    """Return a point on a side (1 left, -1 right) of the line, about within its own extent."""
    while True:
        point = (
            rng.between(min(0, along[0]), max(0, along[0])),
            rng.between(-WIDTH + max(0, along[1]), WIDTH + min(0, along[1])),
        )
        if side * cross(along, point) > 0:
            return point


def _flat_corner(rng: Rng) -> tuple[Point, Point]:
    """Return two vectors of nearly (10^8, 10^8) with cross product 1."""
    low = 96 * LIMIT // 100
    while True:
        x, y = rng.between(low, LIMIT), rng.between(low, LIMIT)
        if gcd(x, y) == 1:
            right = step_right((x, y))
            second = x - right[0], y - right[1]
            if min(second) >= low:
                return (x, y), second


def _near(rng: Rng, edge: Point) -> Point:
    """Return a point on the left of the edge, some hundred units away at most."""
    while True:
        point = any_vector(rng, 300)
        if cross(edge, point) > 0:
            return point


def _tip(rng: Rng, along: Point, square: Point, side: int) -> list[Point]:
    """Return two or three points behind a tip at the origin: on the left (1) or right (-1)."""
    scale = max(map(abs, along))
    wide = rng.choice((1, 2, 5, 1 + max(map(abs, square)) // 10_000))
    found = []
    for _ in range(rng.between(2, 3)):
        percent, lean = rng.between(20, 100), rng.between(-wide, wide)
        found.append(
            (
                side * square[0] * percent // 100 + lean * along[0] // scale + rng.below(2),
                side * square[1] * percent // 100 + lean * along[1] // scale + rng.below(2),
            )
        )
    return found


def _needle(rng: Rng, direction: Point, times: int) -> Polygon:
    """Return a thin triangle from the origin along so many times a direction.

    Its bounding box is that of the long edge: so the centres of two such are on one line.
    """
    x, y = times * direction[0], times * direction[1]
    wide = rng.choice((1, 1, 2, max(1, max(map(abs, direction)) // 1_000)))
    inward_x = min(abs(x), rng.between(0, wide)) * (-1 if x > 0 else 1)
    inward_y = min(abs(y), rng.between(0, wide)) * (-1 if y > 0 else 1)
    return hull([(0, 0), (x, y), (x + inward_x, y + inward_y)])
