"""A scenario, how scenarios become an input file, and how a valid file is read again."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import chain

from gen.geometry import Point, Polygon, translated
from gen.rng import Rng

LIMIT = 100_000_000  # |x|, |y| of everything; the validator proves it against problem.toml

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


def bounds(scenario: Scenario) -> Box:
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


def fits(scenario: Scenario) -> bool:
    """Tell whether everything fits the coordinate limit after some translation."""
    left, bottom, right, top = bounds(scenario)
    return right - left <= 2 * LIMIT and top - bottom <= 2 * LIMIT


def moved(scenario: Scenario, by: Point) -> Scenario:
    """Return the whole scene translated."""
    obstacles = [translated(obstacle, by) for obstacle in scenario.obstacles]
    return Scenario(translated(scenario.robot, by), scenario.move, obstacles)


def into_corner(rng: Rng, scenario: Scenario) -> Scenario:
    """Return the scene pushed into a random corner of the world: |x| = |y| = LIMIT occur."""
    left, bottom, right, top = bounds(scenario)
    dx = rng.choice((-LIMIT - left, LIMIT - right))
    dy = rng.choice((-LIMIT - bottom, LIMIT - top))
    return moved(scenario, (dx, dy))


def settled(rng: Rng, scenario: Scenario, *, corner: bool) -> Scenario:
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


def disguised(rng: Rng, scenario: Scenario, *, reorder: bool = True) -> Scenario:
    """Return the same question in another dress.

    One of the eight symmetries of the grid, or of sixteen with start and end of the
    move exchanged; every polygon begins at a random vertex; with `reorder` the obstacles
    come in random order.
    """
    robot, move, obstacles = scenario.robot, scenario.move, list(scenario.obstacles)
    if rng.chance(0.5):
        robot, move = translated(robot, move), (-move[0], -move[1])
    turns, mirror = rng.below(4), rng.chance(0.5)
    if reorder:
        rng.shuffle(obstacles)
    turned = SYMMETRIES[turns, mirror]
    (move,) = turned([move])
    left, bottom, right, top = bounds(scenario)
    (x, y), (other_x, other_y) = turned([(left, bottom), (right, top)])
    return Scenario(
        _rotated_start(rng, turned(robot)),
        move,
        [_rotated_start(rng, turned(obstacle)) for obstacle in obstacles],
        (min(x, other_x), min(y, other_y), max(x, other_x), max(y, other_y)),
    )


# By quarter turns and whether there is a reflection after them; all keep counter-clockwise order.
SYMMETRIES: dict[tuple[int, bool], Callable[[Polygon], Polygon]] = {
    (0, False): lambda polygon: polygon,
    (1, False): lambda polygon: [(-y, x) for x, y in polygon],
    (2, False): lambda polygon: [(-x, -y) for x, y in polygon],
    (3, False): lambda polygon: [(y, -x) for x, y in polygon],
    (0, True): lambda polygon: [(-x, y) for x, y in reversed(polygon)],
    (1, True): lambda polygon: [(y, x) for x, y in reversed(polygon)],
    (2, True): lambda polygon: [(x, -y) for x, y in reversed(polygon)],
    (3, True): lambda polygon: [(-y, -x) for x, y in reversed(polygon)],
}


def _rotated_start(rng: Rng, polygon: Polygon) -> Polygon:
    """Return the same polygon written down from a random vertex."""
    start = rng.below(len(polygon))
    return polygon[start:] + polygon[:start]
