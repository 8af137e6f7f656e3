"""Where scenarios to disagree about come from: complete small worlds, and chance."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product

from gen.geometry import Point, Polygon, hull, translated
from gen.rng import Rng
from gen.scenario import Scenario


def grid_polygons(side: int) -> list[Polygon]:
    """Return every strictly convex polygon whose vertices lie on the side x side grid.

    Placed, not up to translation: 168 on the 3 x 3 grid. At most two vertices lie in
    each row, so no more than 2 * side are tried.
    """
    points = _square(0, side - 1)
    return [
        polygon
        for n in range(3, 2 * side + 1)
        for chosen in combinations(points, n)
        if len(polygon := hull(list(chosen))) == n
    ]


def small_world(side: int, reach: int) -> Iterator[Scenario]:
    """Yield every scenario of one robot and one obstacle in a small world.

    The robot is any strictly convex polygon on the side x side grid, the obstacle any
    on that grid moved by (a, b), 0 <= b <= a <= side: all other such (a, b) are images
    of these under the symmetries of the grid. The displacement is any with
    |dx|, |dy| <= reach. Which vertex a polygon begins with depends on the scenario's
    number, so that all first vertices occur. 7,056,000 scenarios for (3, 2).
    """
    polygons = grid_polygons(side)
    offsets = [(a, b) for a, b in _square(0, side) if b <= a]
    moves = _square(-reach, reach)
    world = product(offsets, polygons, polygons, moves)
    for number, (offset, robot, obstacle, move) in enumerate(world):
        yield Scenario(
            _begin(robot, number), move, [translated(_begin(obstacle, number // 7), offset)]
        )


def random_scenarios(seed: int, count: int) -> Iterator[Scenario]:
    """Yield tiny random scenarios, of several obstacles or none, that often just touch.

    Equal seeds give equal scenarios. O(1) each, after a stock of shapes has been made.
    """
    rng = Rng(seed)
    stock = [_random_polygon(rng, rng.between(2, 7)) for _ in range(2_000)]
    for _ in range(count):
        reach = rng.between(1, 9)
        obstacles = [
            _begin(translated(rng.choice(stock), _vector(rng, reach)), rng.below(8))
            for _ in range(rng.choice((0, 1, 1, 1, 1, 2, 2, 3)))
        ]
        robot = translated(rng.choice(stock), _vector(rng, reach))
        yield Scenario(_begin(robot, rng.below(8)), _vector(rng, reach), obstacles)


def _random_polygon(rng: Rng, size: int) -> Polygon:
    while True:
        points = [(rng.below(size), rng.below(size)) for _ in range(rng.between(3, 12))]
        polygon = hull(points)
        if len(polygon) >= 3:
            return polygon


def _vector(rng: Rng, reach: int) -> Point:
    return rng.between(-reach, reach), rng.between(-reach, reach)


def _begin(polygon: Polygon, at: int) -> Polygon:
    """Return the polygon beginning with another vertex."""
    at %= len(polygon)
    return polygon[at:] + polygon[:at]


def _square(low: int, high: int) -> list[Point]:
    """Return all points with both coordinates from low to high."""
    return [(x, y) for x in range(low, high + 1) for y in range(low, high + 1)]
