"""Scenarios read from a valid input file."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from gen.geometry import Polygon
from gen.scenario import Scenario


class ReadError(Exception):
    """The file is no input file of this problem; the message says which and what to do."""


def read_scenarios(path: Path) -> Iterator[Scenario]:
    """Yield the scenarios of a file, in their order. O(size). Raises ReadError.

    Only the number of tokens is checked here: the input validator says what exactly
    is wrong with a file.
    """
    try:
        numbers = iter([int(token) for token in path.read_bytes().split()])
    except OSError as error:
        raise ReadError(f"{path}: cannot be read: {error.strerror}") from None
    except ValueError:
        raise ReadError(f"{path}: not a valid input file; see: python -m gen check") from None
    try:
        for _ in range(next(numbers)):
            m, k, dx, dy = (next(numbers) for _ in range(4))
            robot = _polygon(numbers, m)
            obstacles = [_polygon(numbers, next(numbers)) for _ in range(k)]
            yield Scenario(robot, (dx, dy), obstacles)
    except (StopIteration, RuntimeError):
        raise ReadError(f"{path}: ends too early; see: python -m gen check") from None


def _polygon(numbers: Iterator[int], n: int) -> Polygon:
    return [(next(numbers), next(numbers)) for _ in range(n)]
