"""Simpler displacements."""

from __future__ import annotations

from collections.abc import Iterator

from gen.geometry import Point, minus, primitive, translated
from gen.rng import Rng
from gen.scenario import Scenario

NEAR = range(-2, 3)
SMALL = range(-3, 4)


def simpler_moves(scenario: Scenario, _rng: Rng) -> Iterator[Scenario]:
    """Yield the scene with another displacement, from the same start or to the same end."""
    for move in _moves(scenario.move):
        yield Scenario(scenario.robot, move, scenario.obstacles)
        start = translated(scenario.robot, minus(scenario.move, move))
        yield Scenario(start, move, scenario.obstacles)


def _moves(move: Point) -> Iterator[Point]:
    dx, dy = move
    yield 0, 0
    yield dx, 0
    yield 0, dy
    if move != (0, 0):
        yield primitive(move)
    yield from ((x, y) for x in SMALL for y in SMALL)
    for part in (2, 3, 4, 8, 16, 64, 1024):
        shorter = dx - dx // part, dy - dy // part
        yield from ((dx // part, dy // part), shorter, (shorter[0], dy), (dx, shorter[1]))
        yield from ((dx // part, dy), (dx, dy // part))
    yield from ((dx + x, dy + y) for x in NEAR for y in NEAR)
