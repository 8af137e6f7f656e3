"""Reading an input file that the validator has passed."""

from __future__ import annotations

from collections.abc import Iterator

from gen.geometry import Polygon
from gen.scenario import Scenario


def parse(content: bytes) -> list[Scenario]:
    """Return the scenarios of a valid input file. O(size)."""
    numbers = map(int, content.split())
    return [_scenario(numbers) for _ in range(next(numbers))]


def _scenario(numbers: Iterator[int]) -> Scenario:
    m, k, dx, dy = (next(numbers) for _ in range(4))
    robot = _polygon(numbers, m)
    return Scenario(robot, (dx, dy), [_polygon(numbers, next(numbers)) for _ in range(k)])


def _polygon(numbers: Iterator[int], n: int) -> Polygon:
    return [(next(numbers), next(numbers)) for _ in range(n)]
