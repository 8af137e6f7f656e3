#!/usr/bin/env python3
r"""Input validator: stands alone, reads `problem.toml` beside the kit, and nothing else of it.

    python gen/validator.py [--group NAME] [FILE ...]     (no FILE: standard input)

It reads as the grammar of the input, token by token and byte by byte, and shares no
code with the tools that read what teams print:

    file      = t "\n" scenario * t
    scenario  = m " " k "\n" dx " " dy "\n" vertex * m  obstacle * k
    obstacle  = n "\n" vertex * n
    vertex    = x " " y "\n"
    integer   = "0" | ["-"] ("1" ... "9") ("0" ... "9") *

Exit status 0: valid. 1: not; one line says where, what was expected and what was found.
2: usage. Lines are read with a bound, so a hostile file costs no more memory than a
valid one, and the first fault ends the reading, of later files, too.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Callable
from contextlib import nullcontext
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import BinaryIO

_ROOT = Path(__file__).resolve().parent.parent
_LINE_BYTES = 64  # more than any valid line has
_SHOWN_BYTES = 24  # of a bad line in a message
_NUMBER = re.compile(rb"0|-?[1-9][0-9]{0,17}")
_PAIR = re.compile(rb"(0|-?[1-9][0-9]{0,17}) (0|-?[1-9][0-9]{0,17})\n")
_SINGLE = re.compile(rb"(0|-?[1-9][0-9]{0,17})\n")

Vertex = tuple[int, int]


class InputError(Exception):
    """The input is not valid: `line` (1-based) and what is wrong there."""

    def __init__(self, line: int, reason: str) -> None:
        super().__init__(line, reason)
        self.line = line
        self.reason = reason


class UsageError(Exception):
    """The validator cannot do its work: no such group, or no usable declaration."""


@dataclass(frozen=True)
class Rules:
    """The constraints of the problem, and the promises of one group (None, False: none)."""

    max_scenarios: int
    max_vertices: int
    max_coordinate: int
    min_polygon_vertices: int
    max_pair_sum: int | None = None
    zero_displacement: bool = False


@dataclass(frozen=True)
class Summary:
    """What a valid file holds. `pair_sum` is the sum of k * m over its scenarios."""

    scenarios: int
    vertices: int
    pair_sum: int


def load_rules(group: str | None = None, path: Path = _ROOT / "problem.toml") -> Rules:
    """Return the rules for a group, or for any file. UsageError if there are none."""
    import tomllib  # not at the top: packages for judges with an older Python have no such file

    try:
        problem = tomllib.loads(path.read_text(encoding="utf-8"))
        constraints = dict(problem["constraints"])
        promises = {entry["name"]: entry for entry in problem["groups"]}
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise UsageError(f"{path}: no usable constraints and groups: {error}") from None
    if group is not None:
        if group not in promises:
            raise UsageError(f"no group {group!r}; expected one of {', '.join(promises)}")
        promise = promises[group]
        constraints["max_vertices"] = min(
            constraints["max_vertices"], promise.get("max_vertices", constraints["max_vertices"])
        )
        constraints["max_pair_sum"] = promise.get("max_pair_sum")
        constraints["zero_displacement"] = promise.get("zero_displacement", False)
    try:
        return Rules(**constraints)
    except TypeError as error:
        raise UsageError(f"{path}: constraints: {error}") from None


def validate(stream: BinaryIO, rules: Rules) -> Summary:
    """Read the stream to its end; return what it holds, or raise InputError at the first fault.

    O(vertices) time; memory for one polygon.
    """
    return _Reader(stream, rules).file()


class _Reader:
    """A recursive descent over the grammar; `line` is the number of the line read last."""

    def __init__(self, stream: BinaryIO, rules: Rules) -> None:
        self._readline: Callable[[int], bytes] = stream.readline
        self._rules = rules
        self.line = 0
        self._vertices = 0
        self._pair_sum = 0

    def file(self) -> Summary:
        scenarios = self._single("t", 1, self._rules.max_scenarios, "")
        for _ in range(scenarios):
            self._scenario()
        extra = self._readline(_LINE_BYTES)
        if extra:
            raise InputError(self.line + 1, f"expected the end of the file, found {_shown(extra)}")
        return Summary(scenarios, self._vertices, self._pair_sum)

    def _scenario(self) -> None:
        rules = self._rules
        m, k = self._pair("m k", "")
        self._range(m, "m", rules.min_polygon_vertices, rules.max_vertices, "")
        self._range(k, "k", 0, rules.max_vertices // rules.min_polygon_vertices, "")
        self._count_vertices(m)
        self._pair_sum += k * m
        if rules.max_pair_sum is not None and self._pair_sum > rules.max_pair_sum:
            raise InputError(
                self.line,
                f"k * m: expected a sum of at most {rules.max_pair_sum} in this group, "
                f"found {self._pair_sum} up to here",
            )
        dx, dy = self._pair("dx dy", "")
        reach = 2 * rules.max_coordinate
        self._range(dx, "dx", -reach, reach, "")
        self._range(dy, "dy", -reach, reach, "")
        if rules.zero_displacement and (dx, dy) != (0, 0):
            raise InputError(self.line, f"dx dy: expected 0 0 in this group, found {dx} {dy}")
        self._polygon("robot", m, (dx, dy))
        for number in range(1, k + 1):
            name = f"obstacle {number}"
            n = self._single("n", rules.min_polygon_vertices, rules.max_vertices, f"{name}, ")
            self._count_vertices(n)
            self._polygon(name, n, (0, 0))

    def _count_vertices(self, count: int) -> None:
        self._vertices += count
        most = self._rules.max_vertices
        if self._vertices > most:
            raise InputError(
                self.line,
                f"vertices: expected at most {most} in the file, found {self._vertices} up to here",
            )

    def _polygon(self, name: str, n: int, move: Vertex) -> None:
        """Read n vertices: within the limit (after the move too), strictly convex, one winding."""
        first_line = self.line + 1
        low_x, high_x = self._room(move[0])
        low_y, high_y = self._room(move[1])
        vertices: list[Vertex] = []
        for index in range(1, n + 1):
            line = self._readline(_LINE_BYTES)
            self.line += 1
            match = _PAIR.fullmatch(line)
            if match is None:
                raise InputError(self.line, f"{name}, vertex {index}: " + _fault(line, 2))
            x, y = int(match[1]), int(match[2])
            if not (low_x <= x <= high_x and low_y <= y <= high_y):
                self._out_of_bounds(f"{name}, vertex {index}: ", (x, y), move)
            vertices.append((x, y))
        self._convex(name, vertices, first_line)

    def _room(self, delta: int) -> tuple[int, int]:
        """Return the coordinates that are within the limit now and `delta` further."""
        most = self._rules.max_coordinate
        return -most - min(delta, 0), most - max(delta, 0)

    def _out_of_bounds(self, where: str, vertex: Vertex, move: Vertex) -> None:
        most = self._rules.max_coordinate
        for name, start, delta in zip("xy", vertex, move, strict=True):
            self._range(start, name, -most, most, where)
            self._range(start + delta, f"{name} at the end of the move", -most, most, where)

    def _convex(self, name: str, vertices: list[Vertex], first_line: int) -> None:
        """Check every turn, and that the turns add up to one winding."""
        n = len(vertices)
        (ax, ay), (bx, by) = vertices[0], vertices[1]
        ex, ey = bx - ax, by - ay
        was_upper = ey > 0 or (ey == 0 and ex > 0)
        windings = 0
        for index, (cx, cy) in enumerate(chain(vertices[2:], vertices[:2]), start=1):
            fx, fy = cx - bx, cy - by
            turn = ex * fy - ey * fx  # at vertices[index % n]
            if turn <= 0:
                at, kind = index % n, "clockwise turn" if turn < 0 else "no turn"
                if (ex, ey) == (0, 0):
                    kind = "the same vertex again"
                if (fx, fy) == (0, 0):
                    at, kind = min(index + 1, n - 1), "the same vertex again"
                raise InputError(first_line + at, f"{name}, vertex {at + 1}: {kind} (cross {turn})")
            is_upper = fy > 0 or (fy == 0 and fx > 0)
            windings += is_upper and not was_upper
            bx, by, ex, ey, was_upper = cx, cy, fx, fy, is_upper
        if windings != 1:
            raise InputError(
                first_line + len(vertices) - 1,
                f"{name}: expected one turn around, found {windings}",
            )

    def _single(self, name: str, low: int, high: int, where: str) -> int:
        """Read a line of one integer within bounds."""
        line = self._readline(_LINE_BYTES)
        self.line += 1
        match = _SINGLE.fullmatch(line)
        if match is None:
            raise InputError(self.line, f"{where}{name}: " + _fault(line, 1))
        value = int(match[1])
        self._range(value, name, low, high, where)
        return value

    def _pair(self, name: str, where: str) -> Vertex:
        """Read a line of two integers."""
        line = self._readline(_LINE_BYTES)
        self.line += 1
        match = _PAIR.fullmatch(line)
        if match is None:
            raise InputError(self.line, f"{where}{name}: " + _fault(line, 2))
        return int(match[1]), int(match[2])

    def _range(self, value: int, name: str, low: int, high: int, where: str) -> None:
        if not low <= value <= high:
            raise InputError(self.line, f"{where}{name}: expected {low}..{high}, found {value}")


def _fault(line: bytes, count: int) -> str:
    """Return what is wrong with a line that should be `count` integers."""
    wanted = "one integer" if count == 1 else "two integers and one space between"
    if not line:
        return f"expected {wanted}, found the end of the file"
    if not line.endswith(b"\n"):
        if len(line) >= _LINE_BYTES:
            return f"expected {wanted}, found a line that begins {_shown(line)}"
        return f"expected a line end after {_shown(line)}, found the end of the file"
    body = line[:-1]
    if body.endswith(b"\r"):
        return "expected the line to end in \\n, found \\r\\n"
    if body != body.strip() or b"  " in body:
        return f"expected {wanted}, found a blank too much in {_shown(body)}"
    tokens = body.split(b" ")
    if len(tokens) != count or tokens == [b""]:
        return f"expected {wanted}, found {_shown(body)}"
    bad = next(token for token in tokens if _NUMBER.fullmatch(token) is None)
    return (
        f"expected an integer of at most 18 digits, no leading zero, no plus, found {_shown(bad)}"
    )


def _shown(text: bytes) -> str:
    """Return the head of some bytes, printable and quoted."""
    return repr(text[:_SHOWN_BYTES])[1:] + ("..." if len(text) > _SHOWN_BYTES else "")


def main(arguments: list[str]) -> int:
    """Validate files up to the first that is not valid; return the exit status."""
    parser = argparse.ArgumentParser(description="Validate input files.")
    parser.add_argument("files", nargs="*", type=Path, metavar="FILE")
    parser.add_argument("--group", help="hold the file to this group's promises too")
    options = parser.parse_args(arguments)
    try:
        rules = load_rules(options.group)
    except UsageError as error:
        print(error, file=sys.stderr)
        return 2
    statuses = (_status(file, rules) for file in options.files or [None])
    return next((status for status in statuses if status), 0)


def _status(file: Path | None, rules: Rules) -> int:
    """Validate one file, None for standard input; print its fault and return the status."""
    name = str(file or "standard input")
    if file is None and sys.stdin is None:
        print(f"{name}: is closed", file=sys.stderr)
        return 2
    try:
        with nullcontext(sys.stdin.buffer) if file is None else file.open("rb") as stream:
            validate(stream, rules)
    except OSError as error:
        print(f"{name}: cannot be read: {error.strerror}", file=sys.stderr)
        return 2
    except InputError as fault:
        print(f"{name}:{fault.line}: {fault.reason}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except KeyboardInterrupt:
        sys.exit(130)
