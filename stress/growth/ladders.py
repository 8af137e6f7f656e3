"""Ladders: inputs in which one quantity N grows and all others stay; and the fit of a time to N.

Every scene is answered YES, and the obstacles stand closely around the sweep, so that no method
can stop early or rule out an obstacle by its distance.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import log
from statistics import linear_regression

from gen.families import find
from gen.families.common import fitting
from gen.families.size.hugging import around
from gen.geometry import sweep
from gen.geometry.contact import pair
from gen.rng import Rng, derive
from gen.scenario import LIMIT, Scenario, bounds, moved
from gen.shapes.convex import near_circle

FEW = 20  # obstacles: with a single one, some methods are done early, by chance
REPEAT = 1  # of the seed: equal sizes, equal inputs
TRIES = 100
LONG_MOVE = 120_000_000, 40_000_000  # across most of the world
WIDE = 60  # times N: the length of an edge that is about as wide as a robot of N vertices


@dataclass(frozen=True, slots=True)
class Ladder:
    """One quantity. `make` returns the scenarios of an input for one N.

    quantity: completes `the time grows in ...`. least, most: the values of N. may: the time may
    grow like N ** may, up to logarithms. harder_than: the ladder of which this one is a harder
    form: it tells something only where that one is climbed fast.
    """

    name: str
    quantity: str
    make: Callable[[int], list[Scenario]]
    least: int
    most: int
    may: float = 1.0
    harder_than: str = ""


def _family(
    name: str, parameters: Callable[[int], Mapping[str, int]]
) -> Callable[[int], list[Scenario]]:
    def make(size: int) -> list[Scenario]:
        chosen: dict[str, int | str] = {"scenarios": 1, "deciding": "none", **parameters(size)}
        return find(name).scenarios(chosen, REPEAT)

    return make


def _long_moves(size: int) -> list[Scenario]:
    """Return a scene with a move of `size` units and one obstacle beyond its end."""
    robot = [(0, 0), (1, 0), (1, 1), (0, 1)]
    start = -LIMIT
    beyond = [(start + size + 3 + x, y) for x, y in robot]
    return [Scenario([(start + x, y) for x, y in robot], (size, 0), [beyond])]


def _far_pair(size: int) -> list[Scenario]:
    """Return a scene with a long move, which is the same for all sizes, past one obstacle."""
    rng = Rng(derive("far-pair", {"size": size}, REPEAT))
    robot, shape = near_circle(rng, size), near_circle(rng, size)
    (beside,) = around(rng, sweep(robot, LONG_MOVE), 1)

    def make() -> Scenario:
        scene = Scenario(robot, LONG_MOVE, [pair(rng, beside, shape, flat=0).missing])
        left, bottom, _, _ = bounds(scene)
        return moved(scene, (-LIMIT - left, -LIMIT - bottom))

    return [fitting(make, TRIES, "no scene with a long move fits the world")]


# One quantity alone comes before two together, so that the simpler of two causes is told first.
LADDERS = (
    Ladder(
        "robot",
        "the number of robot vertices (with twenty obstacles, triangles)",
        _family("hugging", lambda size: {"m": size, "obstacles": FEW}),
        *(256, 100_000),
    ),
    Ladder(
        "obstacle",
        "the number of vertices of each obstacle (twenty of them, and the robot is a triangle)",
        _family("hugging", lambda size: {"m": 3, "obstacles": FEW, "n": size}),
        *(64, 10_000),
    ),
    Ladder(
        "obstacles",
        "the number of obstacles (the robot and all obstacles are triangles)",
        _family("hugging", lambda size: {"m": 3, "obstacles": size, "far": 1_000_000}),
        *(256, 10_000),
    ),
    Ladder(
        "scenarios",
        "the number of scenarios (each with a robot and one obstacle, triangles)",
        _family("hugging", lambda size: {"scenarios": size, "m": 3, "obstacles": 1}),
        *(256, 5_000),
    ),
    Ladder(
        "move",
        "the length of the move (the robot and the obstacle are squares)",
        _long_moves,
        *(100_000, 100_000_000),
        may=0.0,
    ),
    Ladder(
        "pair",
        "the number of vertices (a robot and one obstacle of N vertices each)",
        _family("hugging", lambda size: {"m": size, "obstacles": 1, "n": size}),
        *(256, 50_000),
    ),
    Ladder(
        "far-pair",
        "the number of vertices (a robot and one obstacle of N vertices each, a long move)",
        _far_pair,
        *(256, 50_000),
        harder_than="pair",
    ),
    Ladder(
        "triangles",
        "the number of vertices (a robot of N vertices among N / 3 small triangles)",
        _family("hugging", lambda size: {"m": size, "obstacles": size // 3, "n": 3}),
        *(256, 40_000),
    ),
    Ladder(
        "wide-triangles",
        "the number of vertices (a robot of N vertices among N / 3 wide triangles)",
        _family("tangents", lambda n: {"m": n, "obstacles": n // 3, "length": WIDE * n}),
        *(256, 40_000),
        harder_than="triangles",
    ),
)
BY_NAME = {ladder.name: ladder for ladder in LADDERS}


def exponent(sizes: Sequence[float], seconds: Sequence[float]) -> float:
    """Return b of the curve a * n ** b that fits best: least squares of the logarithms.

    >>> exponent([1, 2, 4], [3, 12, 48])
    2.0
    """
    return round(linear_regression([log(n) for n in sizes], [log(s) for s in seconds]).slope, 2)
