"""Non-convex obstacles cut into convex pieces: rooms, stars and mazes.

Attacks programs that rely on obstacles not to touch or overlap one another.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Annotated

from gen.families.common import any_shape, any_vector, filled
from gen.families.registry import Between, Flag, Move, OneOf, Scenarios, Vertices, family
from gen.geometry import Point, Polygon, apart, cross, minus, primitive, sweep, translated
from gen.geometry.decompose import convex_pieces
from gen.rng import Rng
from gen.scenario import Scenario
from gen.shapes.edges import angle_key

KINDS = ("star", "room", "maze")


TRIES = 30


def star(rng: Rng, corners: int, size: int) -> Polygon:
    """Return a polygon, star-shaped about (0, 0), mostly not convex, |x|, |y| <= size.

    At most `corners` vertices; consecutive ones are less than half a turn apart.
    """
    while True:
        spokes = {primitive(v): v for v in (any_vector(rng, size) for _ in range(corners))}
        ring = sorted(spokes.values(), key=angle_key)
        n = len(ring)
        if n < 4 or any(cross(ring[i - 1], ring[i]) <= 0 for i in range(n)):
            continue
        straight = (
            cross(minus(ring[i - 1], ring[i - 2]), minus(ring[i], ring[i - 1])) == 0
            for i in range(n)
        )
        if not any(straight):
            return ring


def walls(rng: Rng, ring: Polygon) -> list[Polygon]:
    """Return triangles that stand on the edges of a star-shaped room, outside of it.

    Each apex lies in the cone of its edge as seen from (0, 0): no wall enters the room.
    """
    pieces: list[Polygon] = []
    for a, b in zip([ring[-1], *ring[:-1]], ring, strict=True):
        depth = rng.between(1, 3)
        pieces.append([b, a, (depth * (a[0] + b[0]), depth * (a[1] + b[1]))])
    return pieces


def maze(rng: Rng, columns: int, rows: int, cell: int) -> list[Polygon]:
    """Return the wall boxes of a random maze: every cell is reached, walls are one thick.

    Cells are `cell` wide inside. Source: randomised depth-first search.
    """
    open_walls: set[tuple[Point, Point]] = set()
    seen, path = {(0, 0)}, [(0, 0)]
    while path:
        x, y = path[-1]
        steps = [
            (x + sx, y + sy)
            for sx, sy in ((1, 0), (-1, 0), (0, 1), (0, -1))
            if 0 <= x + sx < columns and 0 <= y + sy < rows and (x + sx, y + sy) not in seen
        ]
        if not steps:
            path.pop()
            continue
        there = rng.choice(steps)
        open_walls.add((min((x, y), there), max((x, y), there)))
        seen.add(there)
        path.append(there)
    pitch = cell + 1
    boxes: list[Polygon] = []
    for x in range(columns):
        for y in range(rows):
            left, bottom = x * pitch, y * pitch
            if y and ((x, y - 1), (x, y)) not in open_walls:
                boxes.append(_box(left, bottom, left + pitch + 1, bottom + 1))
            if x and ((x - 1, y), (x, y)) not in open_walls:
                boxes.append(_box(left, bottom, left + 1, bottom + pitch + 1))
    width, height = columns * pitch, rows * pitch
    return [
        *boxes,
        _box(0, 0, width + 1, 1),
        _box(0, height, width + 1, height + 1),
        _box(0, 0, 1, height + 1),
        _box(width, 0, width + 1, height + 1),
    ]


def _box(left: int, bottom: int, right: int, top: int) -> Polygon:
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def random_map(rng: Rng, most: int) -> Callable[[Polygon], Polygon]:
    """Return a random linear map of the grid with determinant > 0: contacts stay contacts."""
    while True:
        a, b = any_vector(rng, most), any_vector(rng, most)
        if cross(a, b) > 0:
            return lambda points: [(x * a[0] + y * b[0], x * a[1] + y * b[1]) for x, y in points]


def longest_free(robot: Polygon, step: Point, pieces: list[Polygon], most: int) -> int:
    """Return the largest number of steps <= most that meet nothing, -1 if the robot does already.

    O(log most) tries of all pieces.
    """

    def free(steps: int) -> bool:
        covered = sweep(robot, (steps * step[0], steps * step[1])).vertices
        return all(apart(covered, piece) for piece in pieces)

    if not free(0):
        return -1
    low, high = 0, most + 1  # low steps are free, high steps are not (or too many)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if free(middle) else (low, middle)
    return low


@family
def rooms(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    kind: Annotated[str, OneOf(("all", *KINDS))] = "all",
    corners: Annotated[int, Between(5, 60)] = 14,
    size: Annotated[int, Between(4, 1_000)] = 16,
    robot: Annotated[int, Between(1, 1_000)] = 5,
    shear: Annotated[int, Between(1, 20_000)] = 3,
    move: Move = "any",
    corner: Flag = 0,
) -> Iterator[Scenario]:
    """Non-convex rooms, stars and mazes: the robot stops at the last free step, or one later.

    The obstacles are cut into convex pieces. A random integer matrix with entries up to
    `shear` maps everything, so that walls go in any direction. Without a move, the robot
    stands where it would have stopped.
    """
    kinds = [kind] if kind != "all" else list(KINDS)

    def make() -> Scenario | None:
        scenario = _stopping(rng, rng.choice(kinds), corners, size, robot, shear)
        if scenario is None or move == "any":
            return scenario
        return Scenario(translated(scenario.robot, scenario.move), (0, 0), scenario.obstacles)

    yield from filled(rng, make, vertices=vertices, scenarios=scenarios, corner=corner)


def _stopping(
    rng: Rng, kind: str, corners: int, size: int, robot_size: int, shear: int
) -> Scenario | None:
    """Return a scene of a kind in KINDS, None if the robot cannot stand or never stops."""
    if kind == "maze":
        cell = robot_size + rng.below(2)
        cells = max(2, min(5, 2 * size // (cell + 1)))
        middle = -cells * (cell + 1) // 2
        pieces = [translated(each, (middle, middle)) for each in maze(rng, cells, cells, cell)]
    else:
        ring = star(rng, corners, size)
        pieces = convex_pieces(ring) if kind == "star" else walls(rng, ring)
    shape = any_shape(rng, robot_size, 6)
    step = primitive(any_vector(rng, rng.choice((1, 3, size))))
    for _ in range(TRIES):
        robot = translated(shape, (rng.between(-size, size), rng.between(-size, size)))
        steps = longest_free(robot, step, pieces, 4 * size)
        if 0 <= steps < 4 * size:
            mapped = random_map(rng, shear)
            ((dx, dy),) = mapped([step])
            steps += rng.below(2)
            return Scenario(mapped(robot), (steps * dx, steps * dy), list(map(mapped, pieces)))
    return None
