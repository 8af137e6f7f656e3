"""Random scenarios for programs to disagree about: tiny scenes in which much just touches."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from gen.geometry import Point, Polygon, hull, translated
from gen.rng import Rng
from gen.scenario import Scenario, render
from stress.compare import File

SHAPES = 2_000
SCENARIOS_PER_FILE = 20_000  # few vertices each: well below every limit


def random_files(seed: int, scenarios: int) -> Iterator[File]:
    """Yield the random scenarios of a seed as input files."""
    source = random_scenarios(seed, scenarios)
    while part := list(islice(source, SCENARIOS_PER_FILE)):
        yield File(render(part), len(part))


def random_scenarios(seed: int, count: int) -> Iterator[Scenario]:
    """Yield tiny random scenarios with up to three obstacles.

    Equal seeds give equal scenarios. O(1) each, after a stock of shapes has been made.
    """
    rng = Rng(seed)
    stock = [_random_polygon(rng, rng.between(2, 7)) for _ in range(SHAPES)]
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
