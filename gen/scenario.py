"""A scenario, how scenarios become an input file, and how a valid file is read again."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import chain

from gen.geometry import Point, Polygon, translated
from gen.rng import Rng

LIMIT = 100_000_000  # most |x| and |y|; the validator checks every file against problem.toml

Box = tuple[int, int, int, int]  # left, bottom, right, top


@dataclass(frozen=True)
class Scenario:
    """One question: may `robot` make `move` without touching an obstacle?

    known_box: its bounds if whoever makes it knows them already.
    """

    robot: Polygon
    move: Point
    obstacles: list[Polygon]
    known_box: Box | None = field(default=None, compare=False, repr=False)

    @property
    def vertices(self) -> int:
        """The number of vertices, robot and obstacles together."""
        return len(self.robot) + sum(map(len, self.obstacles))


@dataclass(frozen=True, slots=True)
class Disguise:
    """The same question in another dress, to be placed in the world by `moved`.

    symmetry: quarter turns, and whether there is a reflection after them. starts: with which
    vertex each polygon begins after that, the robot first. known_box: its bounds.
    """

    scenario: Scenario
    symmetry: tuple[int, bool]
    starts: list[int]
    known_box: Box


Scene = Scenario | Disguise


def render(scenarios: Iterable[Scenario]) -> bytes:
    """Return the input file of the scenarios. O(size)."""
    parts: list[str] = []
    count = 0
    for scenario in scenarios:
        count += 1
        m, k = len(scenario.robot), len(scenario.obstacles)
        dx, dy = scenario.move
        parts.append(f"{m} {k}\n{dx} {dy}")
        parts.extend([f"{x} {y}" for x, y in scenario.robot])
        for obstacle in scenario.obstacles:
            parts.append(str(len(obstacle)))
            parts.extend([f"{x} {y}" for x, y in obstacle])
    return "\n".join([str(count), *parts, ""]).encode()


def parse(content: bytes) -> list[Scenario]:
    """Return the scenarios of an input file that the validator has passed. O(size)."""
    numbers = map(int, content.split())
    return [_scenario(numbers) for _ in range(next(numbers))]


def _scenario(numbers: Iterator[int]) -> Scenario:
    m, k, dx, dy = (next(numbers) for _ in range(4))
    robot = _polygon(numbers, m)
    return Scenario(robot, (dx, dy), [_polygon(numbers, next(numbers)) for _ in range(k)])


def _polygon(numbers: Iterator[int], n: int) -> Polygon:
    return [(next(numbers), next(numbers)) for _ in range(n)]


def bounds(scenario: Scene) -> Box:
    """Return (left, bottom, right, top) of everything, the robot's end included.

    O(vertices) once for each scenario.
    """
    if scenario.known_box is not None:
        return scenario.known_box
    xs, ys = zip(*scenario.robot, strict=True)
    dx, dy = scenario.move
    left, right = min(xs) + min(dx, 0), max(xs) + max(dx, 0)
    bottom, top = min(ys) + min(dy, 0), max(ys) + max(dy, 0)
    if scenario.obstacles:
        xs, ys = zip(*chain.from_iterable(scenario.obstacles), strict=True)
        left, right = min(left, min(xs)), max(right, max(xs))
        bottom, top = min(bottom, min(ys)), max(top, max(ys))
    object.__setattr__(scenario, "known_box", (left, bottom, right, top))
    return left, bottom, right, top


def fits(scenario: Scene) -> bool:
    """Tell whether everything fits the coordinate limit after some translation."""
    left, bottom, right, top = bounds(scenario)
    return right - left <= 2 * LIMIT and top - bottom <= 2 * LIMIT


def moved(scenario: Scene, by: Point) -> Scenario:
    """Return the whole scene translated."""
    if isinstance(scenario, Disguise):
        return _dressed(scenario, by)
    obstacles = [translated(obstacle, by) for obstacle in scenario.obstacles]
    return Scenario(translated(scenario.robot, by), scenario.move, obstacles)


def into_corner(rng: Rng, scenario: Scene) -> Scenario:
    """Return the scene pushed into a random corner of the world: |x| = |y| = LIMIT occur."""
    left, bottom, right, top = bounds(scenario)
    dx = rng.choice((-LIMIT - left, LIMIT - right))
    dy = rng.choice((-LIMIT - bottom, LIMIT - top))
    return moved(scenario, (dx, dy))


def settled(rng: Rng, scenario: Scene, *, corner: bool) -> Scenario:
    """Return the scene somewhere near the origin but inside the world, or in a corner of it."""
    if corner:
        return into_corner(rng, scenario)
    left, bottom, right, top = bounds(scenario)
    x, y = -(left + right) // 2, -(bottom + top) // 2  # from here the middle is the origin
    play_x = min(LIMIT - (right - left + 1) // 2 - 1, right - left)
    play_y = min(LIMIT - (top - bottom + 1) // 2 - 1, top - bottom)
    if play_x < 0 or play_y < 0:
        return into_corner(rng, scenario)
    return moved(scenario, (x + rng.between(-play_x, play_x), y + rng.between(-play_y, play_y)))


def disguised(rng: Rng, scenario: Scenario, *, reorder: bool = True) -> Disguise:
    """Return the same question in another dress.

    One of the eight symmetries of the grid, or of sixteen with start and end of the
    move exchanged; every polygon begins at a random vertex; with `reorder` the obstacles
    come in random order.
    """
    robot, move, obstacles = scenario.robot, scenario.move, list(scenario.obstacles)
    left, bottom, right, top = bounds(scenario)
    if rng.chance(0.5):
        robot, move = translated(robot, move), (-move[0], -move[1])
    symmetry = rng.below(4), rng.chance(0.5)
    if reorder:
        rng.shuffle(obstacles)
    starts = [rng.below(len(polygon)) for polygon in (robot, *obstacles)]
    (x, y), (other_x, other_y) = SYMMETRIES[symmetry]([(left, bottom), (right, top)], 0, 0)
    box = min(x, other_x), min(y, other_y), max(x, other_x), max(y, other_y)
    return Disguise(Scenario(robot, move, obstacles), symmetry, starts, box)


def _dressed(disguise: Disguise, by: Point) -> Scenario:
    """Return the disguised scene, translated, in one pass over its vertices."""
    turned, (dx, dy) = SYMMETRIES[disguise.symmetry], by
    scenario = disguise.scenario
    polygons = [turned(polygon, dx, dy) for polygon in (scenario.robot, *scenario.obstacles)]
    for index, start in enumerate(disguise.starts):
        if start:
            polygons[index] = polygons[index][start:] + polygons[index][:start]
    (move,) = turned([scenario.move], 0, 0)
    return Scenario(polygons[0], move, polygons[1:])


# By quarter turns and whether there is a reflection after them: each turns a polygon so, then
# translates it by (a, b). All keep it counter-clockwise.
SYMMETRIES: dict[tuple[int, bool], Callable[[Polygon, int, int], Polygon]] = {
    (0, False): lambda polygon, a, b: [(a + x, b + y) for x, y in polygon],
    (1, False): lambda polygon, a, b: [(a - y, b + x) for x, y in polygon],
    (2, False): lambda polygon, a, b: [(a - x, b - y) for x, y in polygon],
    (3, False): lambda polygon, a, b: [(a + y, b - x) for x, y in polygon],
    (0, True): lambda polygon, a, b: [(a - x, b + y) for x, y in reversed(polygon)],
    (1, True): lambda polygon, a, b: [(a + y, b + x) for x, y in reversed(polygon)],
    (2, True): lambda polygon, a, b: [(a + x, b - y) for x, y in reversed(polygon)],
    (3, True): lambda polygon, a, b: [(a - y, b - x) for x, y in reversed(polygon)],
}
