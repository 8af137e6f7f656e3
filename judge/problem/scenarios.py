"""Finds scenarios and their sizes in the text of an input file, without a look at geometry."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

_LINE_CHARS = 64  # more than any valid line has


def scenario_lines(path: Path, number: int) -> list[str] | None:
    """Return the lines of scenario `number`, counted from 1, of an input file.

    None: up to its end, the file is no input of this problem, or it cannot be read. O(size).
    """
    try:
        with path.open(encoding="ascii") as file:
            read = partial(file.readline, _LINE_CHARS)
            (scenarios,) = _integers(read(), 1)
            if not 1 <= number <= scenarios:
                return None
            for _ in range(number - 1):
                deque(_scenario(read), maxlen=0)
            return [line.rstrip("\n") for line in _scenario(read)]
    except (OSError, ValueError):
        return None


def polygon_sizes(path: Path) -> list[tuple[int, list[int]]] | None:
    """Return, for each scenario, the vertices of its robot and of each of its obstacles.

    None: the file is no input of this problem, or it cannot be read. O(size).
    """
    sizes = []
    try:
        with path.open(encoding="ascii") as file:
            read = partial(file.readline, _LINE_CHARS)
            (scenarios,) = _integers(read(), 1)
            for _ in range(scenarios):
                lines = list(_scenario(read))
                robot, obstacles = _integers(lines[0], 2)
                at, found = 2 + robot, list[int]()
                for _ in range(obstacles):
                    (size,) = _integers(lines[at], 1)
                    found.append(size)
                    at += 1 + size
                sizes.append((robot, found))
    except (OSError, ValueError):
        return None
    return sizes


def _scenario(read: Callable[[], str]) -> Iterator[str]:
    """Yield the lines of the next scenario. Raises ValueError if the text does not fit."""
    head = read()
    vertices, obstacles = _integers(head, 2)
    yield head
    yield from _pairs(read, 1 + vertices)  # the displacement, and the robot
    for _ in range(obstacles):
        size = read()
        (count,) = _integers(size, 1)
        yield size
        yield from _pairs(read, count)


def _pairs(read: Callable[[], str], count: int) -> Iterator[str]:
    for _ in range(count):
        line = read()
        _integers(line, 2)
        yield line


def _integers(line: str, count: int) -> list[int]:
    """Return the integers of a line. Raises ValueError unless there are `count` of them."""
    values = [int(word) for word in line.split()]
    if len(values) != count:
        raise ValueError(line)
    return values
