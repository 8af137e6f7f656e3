"""The scene scaled down: all numbers divided and rounded, then the hulls of what is left."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import chain
from math import gcd

from gen.geometry import Polygon, hull
from gen.rng import Rng
from gen.scenario import Scenario
from stress.shrinking.steps.polygons import numbered, of_polygons, polygons, with_polygon

# numerator, denominator
FACTORS: tuple[tuple[int, int], ...] = (
    (1, 1_000_000),
    (1, 30_000),
    (1, 1_000),
    (1, 100),
    (1, 30),
    (1, 10),
    (1, 7),
    (1, 5),
)
FACTORS += ((1, 4), (1, 3), (1, 2), (2, 3), (3, 4), (7, 8), (15, 16), (31, 32), (63, 64))
FACTORS += ((255, 256), (1023, 1024), (8191, 8192))
UNITS = (10_000_000, 1_000_000, 100_000, 10_000, 1_000, 100, 10)  # to round all numbers to
MOST_VERTICES = 8

Rounding = Callable[[int, int, int], int]


def scaled_down(scenario: Scenario, _rng: Rng) -> Iterator[Scenario]:
    """Yield the scene scaled in both directions, in one, and each polygon scaled alone."""
    yield from _without_divisor(scenario)
    for unit in UNITS:
        yield _scaled(scenario, 1, unit, _nearest, in_x=True, in_y=True, times=unit)
    for up, down in FACTORS:
        for rounded in (_floor, _nearest, _towards_zero):
            for in_x, in_y in ((True, True), (True, False), (False, True)):
                yield _scaled(scenario, up, down, rounded, in_x=in_x, in_y=in_y)
    for index, polygon in numbered(scenario):
        for x, y in polygon[:MOST_VERTICES]:
            for up, down in FACTORS[-12:]:
                towards = [
                    (x + _nearest(px - x, up, down), y + _nearest(py - y, up, down))
                    for px, py in polygon
                ]
                yield with_polygon(scenario, index, hull(towards))


def _without_divisor(scenario: Scenario) -> Iterator[Scenario]:
    """Yield the scene divided by the greatest common divisor of its numbers, exactly."""
    numbers = chain(scenario.move, chain.from_iterable(chain(*polygons(scenario))))
    divisor = gcd(*numbers)
    if divisor > 1:
        yield _scaled(scenario, 1, divisor, _floor, in_x=True, in_y=True)


def _scaled(
    scenario: Scenario,
    up: int,
    down: int,
    rounded: Rounding,
    *,
    in_x: bool,
    in_y: bool,
    times: int = 1,
) -> Scenario:
    def scale(polygon: Polygon) -> Polygon:
        return [
            (
                rounded(x, up, down) * times if in_x else x,
                rounded(y, up, down) * times if in_y else y,
            )
            for x, y in polygon
        ]

    (move,) = scale([scenario.move])
    return of_polygons([hull(scale(polygon)) for polygon in polygons(scenario)], move)


def _floor(value: int, up: int, down: int) -> int:
    return value * up // down


def _nearest(value: int, up: int, down: int) -> int:
    return (2 * value * up + down) // (2 * down)


def _towards_zero(value: int, up: int, down: int) -> int:
    return value * up // down if value >= 0 else -(-value * up // down)
