"""Complete small worlds: every scenario of one robot and one obstacle, as input files.

A scenario can be written down in many ways: in each of the eight symmetries of the grid, and
with each polygon beginning at any of its vertices. That is its dress, and changes no answer.
The text is joined from pieces that are rendered once, above all the obstacle in each dress at
each place. This writes millions of scenarios a second.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from functools import cache, lru_cache
from itertools import accumulate
from typing import NamedTuple

from gen.geometry import Point, Polygon
from gen.shapes.grids import grid_polygons
from stress.compare import File

SYMMETRIES = 8  # of the square grid
TABLES_KEPT = 1_000  # every dress of a few obstacles

Ring = tuple[Point, ...]
Column = tuple[int, int, int]  # (x, low, high): the places (x, y) with low <= y <= high
Places = Callable[[Point, Point, Point], list[Column]]


class _Row(NamedTuple):
    """The scenarios of one robot, one obstacle and one move: one for each place."""

    move: Point
    columns: list[Column]
    size: int


class World:
    """A complete world; its scenarios are numbered from 0.

    It holds every combination of an obstacle, a robot, a move (dx, dy) with |dx|, |dy| <=
    reach, and a place, which is a vector that the obstacle is translated by. places: a
    function of the greatest coordinates of the robot, those of the obstacle, and the move;
    it returns the places, both coordinates of which are in `extent`.

    Scenarios that differ only in their place form a row. The dress changes from row to row
    so that every dress occurs, with the first `symmetries` of the eight symmetries.
    """

    def __init__(
        self,
        name: str,
        robots: Sequence[Polygon],
        obstacles: Sequence[Polygon],
        reach: int,
        places: Places,
        extent: range,
        symmetries: int = SYMMETRIES,
    ) -> None:
        self._name = name
        self._robots = [tuple(robot) for robot in robots]
        self._obstacles = [tuple(obstacle) for obstacle in obstacles]
        self._extent = extent
        self._symmetries = symmetries
        steps = range(-reach, reach + 1)
        moves = [(dx, dy) for dx in steps for dy in steps]

        @cache
        def rows(robot: Point, obstacle: Point) -> list[_Row]:
            found = []
            for move in moves:
                columns = places(robot, obstacle, move)
                size = sum(high - low + 1 for _, low, high in columns)
                found.append(_Row(move, columns, size))
            return found

        @cache
        def size(robot: Point, obstacle: Point) -> int:
            return sum(row.size for row in rows(robot, obstacle))

        corners = [_corner(robot) for robot in self._robots]
        pairs = [(robot, _corner(obstacle)) for obstacle in self._obstacles for robot in corners]
        self._ends = list(accumulate(size(*pair) for pair in pairs))
        self._rows_of = rows
        self.size = self._ends[-1]

    def __str__(self) -> str:
        return self._name

    def file(self, start: int, scenarios: int) -> File:
        """Return an input file of `scenarios` scenarios from number `start` on, or of the rest."""
        scenarios = left = min(scenarios, self.size - start)
        parts = [f"{scenarios}\n"]
        for head, obstacles in self._texts(start):
            del obstacles[left:]
            parts += (head, head.join(obstacles))
            left -= len(obstacles)
            if not left:
                break
        return File("".join(parts).encode(), scenarios)

    def files(self, scenarios: int, every: int = 1) -> Iterator[File]:
        """Yield the world in files of `scenarios` scenarios; only the first of each `every`."""
        for start in range(0, self.size, scenarios * every):
            yield self.file(start, scenarios)

    def _texts(self, start: int) -> Iterator[tuple[str, list[str]]]:
        """Yield what each row from scenario `start` on repeats, and its obstacles."""
        first = bisect_right(self._ends, start)
        skip = start - (self._ends[first - 1] if first else 0)
        origin = self._extent.start
        for pair in range(first, len(self._ends)):
            which_obstacle, which_robot = divmod(pair, len(self._robots))
            robot, obstacle = self._robots[which_robot], self._obstacles[which_obstacle]
            rows = self._rows_of(_corner(robot), _corner(obstacle))
            for number, (move, columns, size) in enumerate(rows, pair * len(rows)):
                if skip >= size:
                    skip -= size
                    continue
                symmetry = number % self._symmetries
                # Strides without a common divisor, so that dresses of both are combined.
                first_of_robot = number // 8 % len(robot)
                first_of_obstacle = number // 7 % len(obstacle)
                head = _head(robot, first_of_robot, len(obstacle), move, symmetry)
                placed = _placed(obstacle, first_of_obstacle, self._extent, symmetry)
                texts: list[str] = []
                for x, low, high in columns:
                    texts += placed[x - origin][low - origin : high - origin + 1]
                yield head, texts[skip:]
                skip = 0


def grid_world(side: int, reach: int) -> World:
    """Return the world of all pairs of polygons on side x side grids. side >= 2.

    The obstacle is moved by (x, y), 0 <= y <= x <= side: all other such (x, y) are images of
    these under the symmetries of the grid. 7,056,000 scenarios for (3, 2).
    """
    columns = [(x, 0, x) for x in range(side + 1)]
    return World(
        f"all pairs on {side} x {side} grids, all displacements within +-{reach}",
        grid_polygons(side),
        grid_polygons(side),
        reach,
        lambda _robot, _obstacle, _move: columns,
        range(side + 1),
        symmetries=1,
    )


def box_world(robot_side: int, obstacle_side: int, reach: int) -> World:
    """Return the world of all scenarios in which the boxes of sweep and obstacle meet.

    At any other place the answer is YES, and no method has anything to decide. robot: every
    polygon on the robot_side x robot_side grid, up to translation, rotation by 90 degrees
    and reflection. obstacle: every polygon on its grid, up to translation. Both sides >= 2.
    """
    robots = [robot for robot in _pushed(robot_side) if _is_least_of_its_images(robot)]
    return World(
        f"robot on {robot_side} x {robot_side}, obstacle on {obstacle_side} x {obstacle_side}, "
        f"|dx|, |dy| <= {reach}",
        robots,
        _pushed(obstacle_side),
        reach,
        _where_boxes_meet,
        range(1 - obstacle_side - reach, robot_side + reach),
    )


def _where_boxes_meet(robot: Point, obstacle: Point, move: Point) -> list[Column]:
    """Return the places of an obstacle at which its box meets the sweep's. Both are pushed."""
    (width, height), (right, top), (dx, dy) = obstacle, robot, move
    low, high = min(dy, 0) - height, max(dy, 0) + top
    return [(x, low, high) for x in range(min(dx, 0) - width, max(dx, 0) + right + 1)]


@cache
def _pushed(side: int) -> tuple[Polygon, ...]:
    """Return the polygons on a grid up to translation: those that touch both axes."""
    return tuple(polygon for polygon in grid_polygons(side) if _least(polygon) == (0, 0))


def _is_least_of_its_images(polygon: Polygon) -> bool:
    """Tell whether a polygon stands for its images under the symmetries: just one of them does."""
    images = []
    for symmetry in range(SYMMETRIES):
        image = [_turned(point, symmetry) for point in polygon]
        left, bottom = _least(image)
        images.append(sorted((x - left, y - bottom) for x, y in image))
    return images[0] == min(images)


def _least(points: Sequence[Point]) -> Point:
    """Return the least x and the least y."""
    return min(x for x, _ in points), min(y for _, y in points)


@cache
def _corner(points: Ring) -> Point:
    """Return the greatest x and the greatest y."""
    return max(x for x, _ in points), max(y for _, y in points)


def _turned(point: Point, symmetry: int) -> Point:
    """Return the image of a point: bit 0 of `symmetry` flips x, bit 1 y, bit 2 swaps them."""
    x, y = point
    if symmetry & 1:
        x = -x
    if symmetry & 2:
        y = -y
    return (y, x) if symmetry & 4 else (x, y)


def _dressed(ring: Ring, first: int, symmetry: int) -> list[Point]:
    """Return a polygon's image, counter-clockwise, beginning with vertex `first` of it."""
    image = [_turned(point, symmetry) for point in ring]
    if symmetry.bit_count() % 2:  # an odd number of reflections turns the sense
        image.reverse()
    return image[first:] + image[:first]


def _head(robot: Ring, first: int, obstacle_vertices: int, move: Point, symmetry: int) -> str:
    """Return the text of a scenario up to the first vertex of its only obstacle."""
    points = [_turned(move, symmetry), *_dressed(robot, first, symmetry)]
    lines = "".join([f"{x} {y}\n" for x, y in points])
    return f"{len(robot)} 1\n{lines}{obstacle_vertices}\n"


@lru_cache(TABLES_KEPT)
def _placed(obstacle: Ring, first: int, extent: range, symmetry: int) -> list[list[str]]:
    """Return the vertices of an obstacle as text, moved by each (x, y): a list by y for each x.

    Neighbouring places begin with neighbouring vertices.
    """
    rings = [_dressed(obstacle, start, symmetry) for start in range(len(obstacle))]
    table = []
    for x in extent:
        column = []
        for y in extent:
            at_x, at_y = _turned((x, y), symmetry)
            ring = rings[(first + x + y) % len(rings)]
            column.append("".join([f"{px + at_x} {py + at_y}\n" for px, py in ring]))
        table.append(column)
    return table
