"""Many vertices in one polygon, met where programs that skip, cap or guess do not look."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import any_vector, filled, fitting
from gen.families.containment import put_inside
from gen.families.hugging import DECIDING, ROBOTS, big_robot, turns
from gen.families.registry import Between, FamilyError, Length, OneOf, Scenarios, Vertices, family
from gen.geometry import Point, Polygon, minus, primitive, step_right, sweep, translated
from gen.geometry.contact import Support, edge_support, pair, random_support, vertex_support
from gen.rng import Rng
from gen.scenario import LIMIT, Scenario, bounds, disguised, fits, into_corner, moved
from gen.shapes.convex import in_box

TRIES = 20
Far = Annotated[int, Between(0, 2 * LIMIT)]
Robot = Annotated[str, OneOf(ROBOTS)]


@family
def tangents(
    rng: Rng,
    *,
    scenarios: Scenarios = 2,
    m: Vertices = 100,
    obstacles: Annotated[int, Between(1, 166_665)] = 50,
    far: Far = 1_000,
    length: Length = 1_000,
    robot: Robot = "circle",
    deciding: Annotated[str, OneOf(DECIDING)] = "pairs",
) -> Iterator[Scenario]:
    """Triangles with an edge of about `length` that is tangent to the sweep at one vertex.

    All around, each misses by one unit, but the deciding one (see `hugging`). The
    vertices of such an edge are far off, its box and every window of coordinates are
    full of the sweep's edges, and only a search by angle finds the one that matters.
    """
    for who in turns(rng, deciding, scenarios):

        def make(who: str = who) -> Scenario:
            return _with_tangents(rng, big_robot(rng, robot, m), obstacles, far, length, who)

        too_large = "family tangents: no scene fits the world; make it smaller"
        yield into_corner(rng, fitting(make, TRIES, too_large))


def _with_tangents(
    rng: Rng, robot: Polygon, count: int, far: int, length: int, who: str
) -> Scenario:
    move = any_vector(rng, far) if far else (0, 0)
    covered = sweep(robot, move)
    n = len(covered.vertices)
    first = rng.below(n)
    deciding = {"none": -1, "last": count - 1}.get(who, rng.below(count))
    places = [(first + i * n // count) % n for i in range(count)]
    rng.shuffle(places)
    found = []
    for number, index in enumerate(places):
        support = vertex_support(rng, covered, index)
        triangle = _tangent_triangle(rng, support, length)
        gap = (0, 0) if number == deciding else step_right(support.along)
        found.append(translated(triangle, gap))
    return disguised(rng, Scenario(robot, move, found), reorder=False)


def _tangent_triangle(rng: Rng, support: Support, length: int) -> Polygon:
    """Return a triangle on the right of the line whose longest edge has the base in its middle."""
    (x, y), (right_x, right_y) = support.along, step_right(support.along)
    steps = max(2, length * rng.between(50, 100) // 100 // max(abs(x), abs(y)))
    before = steps * rng.between(30, 70) // 100
    high, lean = rng.between(1, 50), steps // 2
    apex = high * right_x + lean * x, high * right_y + lean * y
    # Counter-clockwise, the obstacle has its interior on the left: it runs against `along`.
    around_start = translated([(steps * x, steps * y), (0, 0), apex], (-before * x, -before * y))
    return translated(around_start, support.base)


@family
def poles(
    rng: Rng,
    *,
    scenarios: Scenarios = 3,
    m: Vertices = 600,
    far: Far = 20,
    robot: Robot = "circle",
    pole: Annotated[str, OneOf(("any", "lowest"))] = "any",
) -> Iterator[Scenario]:
    """A large polygon is touched, or missed by one unit, beside its outermost vertices.

    That is where walks along its edges begin and end: the two edges before and after its
    lowest, highest, leftmost or rightmost vertex. Some have edges of several steps, touched
    in between. In every third scene nothing moves, and the large polygon is the obstacle.
    """

    def make(number: int) -> Scenario:
        scale = rng.choice((1, 1, 2, 4))
        large = [(scale * x, scale * y) for x, y in big_robot(rng, robot, m)]
        still = far == 0 or number % 3 == 0
        move = (0, 0) if still else any_vector(rng, far)
        covered = sweep(large, move)
        n = len(covered.vertices)
        up = (0, 1) if pole == "lowest" else rng.choice(((0, 1), (0, -1), (1, 0), (-1, 0)))
        lowest = min(range(n), key=lambda i: (_along(covered.vertices[i], up), covered.vertices[i]))
        support = edge_support(covered, (lowest + rng.between(-2, 1)) % n)
        placed = pair(rng, support, in_box(rng, rng.choice((3, 30)), 3), flat=0)
        little = placed.touching if rng.chance(0.5) else placed.missing
        if number % 3 == 0:
            return Scenario(little, (0, 0), [large])
        return Scenario(large, move, [little])

    for number in range(scenarios):
        scenario = make(number)
        if pole == "any":
            scenario = disguised(rng, scenario)
        if not fits(scenario):
            raise FamilyError("family poles: no scene fits the world; make m or far smaller")
        yield into_corner(rng, scenario)


def _along(point: Point, direction: Point) -> int:
    return point[0] * direction[0] + point[1] * direction[1]


@family
def nested(
    rng: Rng,
    *,
    scenarios: Scenarios = 4,
    m: Vertices = 400,
    size: Length = 5,
    far: Far = 5,
    robot: Robot = "circle",
) -> Iterator[Scenario]:
    """A polygon of m vertices with a triangle inside (NO), around (NO), or beside it (YES).

    Robot and obstacle in either role, the move short, or none. No edge meets another: who
    looks at the edges only, or at some of the vertices, sees nothing.
    """
    for number in range(scenarios):

        def make(number: int = number) -> Scenario | None:
            large = big_robot(rng, robot, m)
            move = (0, 0) if far == 0 or rng.chance(0.3) else any_vector(rng, far)
            return _nested(rng, number, large, move, size)

        too_large = "family nested: no triangle fits; make size, m or far smaller"
        yield into_corner(rng, disguised(rng, fitting(make, TRIES, too_large)))


def _nested(rng: Rng, number: int, large: Polygon, move: Point, size: int) -> Scenario | None:
    """Return the scene with this number, None if the triangle is nowhere inside."""
    little = in_box(rng, size, 3)
    if number % 2:
        covered = sweep(large, move)
        support = edge_support(covered, rng.below(len(covered.vertices)))
        return Scenario(large, move, [pair(rng, support, little, flat=0).missing])
    if number % 8 == 4:
        return Scenario(large, move, [_around(sweep(large, move).vertices)])
    if number % 8 == 6:
        return Scenario(_around(large), move, [large])
    inside = put_inside(rng, large, sweep(little, move).vertices)
    if inside is None:
        return None
    if number % 8 == 2:
        return Scenario(large, move, [translated(inside, move)])
    at, own = min(inside), min(sweep(little, move).vertices)
    return Scenario(translated(little, minus(at, own)), move, [large])


def _around(polygon: Polygon) -> Polygon:
    """Return a triangle that has the polygon strictly inside."""
    left, right = min(x for x, _ in polygon), max(x for x, _ in polygon)
    bottom, top = min(y for _, y in polygon), max(y for _, y in polygon)
    x, y = left - 1, bottom - 1
    return [(x, y), (x + 2 * (right - left) + 8, y), (x, y + 2 * (top - bottom) + 8)]


@family
def facing(
    rng: Rng,
    *,
    scenarios: Scenarios = 2,
    m: Vertices = 400,
    robot: Robot = "arc",
) -> Iterator[Scenario]:
    """A polygon and its mirror image touch with one vertex each (NO), or miss by one unit.

    Nothing moves. No line separates them, or only few do, and no edge meets another but
    at that vertex: tests of one edge after the other that end early never, or hardly, do.
    """
    for number in range(scenarios):
        shape = big_robot(rng, robot, m)
        middle = m // 2
        x, y = shape[middle]
        gap_x, gap_y = 0, 0
        if number % 2:
            gap_x, gap_y = step_right(primitive(minus(shape[middle + 1], shape[middle - 1])))
        image = [(2 * x - vx + gap_x, 2 * y - vy + gap_y) for vx, vy in shape]
        scenario = disguised(rng, Scenario(shape, (0, 0), [image]))
        if not fits(scenario):
            raise FamilyError("family facing: no scene fits the world; make m smaller")
        yield into_corner(rng, scenario)


@family
def twins(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    reach: Length = 12,
    far: Far = 12,
    most: Annotated[int, Between(3, 1_000)] = 9,
) -> Iterator[Scenario]:
    """The obstacle equals the robot: at its start or end, on the way, or beside it by one unit.

    Programs that know shapes by their form, or skip what they think is the robot, fail.
    """

    def make() -> Scenario:
        robot = in_box(rng, reach, rng.between(3, most))
        move = any_vector(rng, far) if far and rng.chance(0.7) else (0, 0)
        if rng.chance(0.4):
            return Scenario(robot, move, [translated(robot, rng.choice(((0, 0), move)))])
        covered = sweep(robot, move)
        support = edge_support(covered, rng.below(len(covered.vertices)))
        placed = pair(rng, support, robot, flat=0)
        return Scenario(robot, move, [placed.missing if rng.chance(0.8) else placed.touching])

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=False)


@family
def longest(rng: Rng, *, scenarios: Scenarios = 100) -> Iterator[Scenario]:
    """Triangles in the lower left corner of the world, moves to the opposite corner.

    Nearly every number has as many digits as it can have: so many bytes a vertex that a
    buffer made for less is too small.
    """
    for _ in range(scenarios):
        while True:
            robot = in_box(rng, 9, 3)
            move = 2 * LIMIT - rng.between(40, 90), 2 * LIMIT - rng.between(40, 90)
            support = random_support(rng, sweep(robot, move), "start")
            placed = pair(rng, support, in_box(rng, 9, 3), flat=0)
            little = placed.touching if rng.chance(0.5) else placed.missing
            scenario = Scenario(robot, move, [little])
            if fits(scenario):
                break
        left, bottom, _, _ = bounds(scenario)
        yield moved(scenario, (-LIMIT - left, -LIMIT - bottom))
