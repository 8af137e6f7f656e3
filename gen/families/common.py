"""What the families share: shapes and moves of every kind, and filling a file."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Annotated, TypeVar

from gen.families.registry import FamilyError, OneOf
from gen.geometry import Point, Polygon, minus, primitive
from gen.rng import Rng
from gen.scenario import Disguise, Scenario, disguised, fits, settled
from gen.shapes.convex import arc, box, in_box, near_circle, needle, random_convex
from gen.shapes.edges import directions

_MOST_TRIES = 10_000

S = TypeVar("S", Scenario, Disguise)

ROBOTS = ("circle", "random", "arc")
DECIDING = ("none", "any", "last", "pairs")
Robot = Annotated[str, OneOf(ROBOTS)]
Deciding = Annotated[str, OneOf(DECIDING)]
MOVES = ("mixed", "zero", "axis", "edge", "tiny", "primitive", "any")


def any_shape(rng: Rng, size: int, most: int) -> Polygon:
    """Return a polygon of any kind with at most `most` vertices, about `size` wide."""
    kind = rng.below(8)
    if kind == 0:
        return box(rng.between(1, size), rng.between(1, size))
    if kind == 1:
        return needle(rng, primitive(any_vector(rng, size)))
    if kind == 2 and most >= 5 and size >= 8:
        return scaled_up(near_circle(rng, rng.between(4, min(most, 12))), size)
    if kind == 3 and most >= 5 and size >= 12:
        return random_convex(rng, rng.between(4, min(most, 10)), stretch=3)
    return in_box(rng, size, rng.between(3, most))


def big_robot(rng: Rng, kind: str, m: int) -> Polygon:
    """Return a robot with exactly m vertices."""
    if kind == "circle":
        return near_circle(rng, m)
    return random_convex(rng, m) if kind == "random" else arc(rng, m)


def scaled_up(polygon: Polygon, size: int) -> Polygon:
    """Return the polygon enlarged by the largest integer that keeps it within `size`."""
    widest = max(max(axis) - min(axis) for axis in zip(*polygon, strict=True))
    factor = max(1, size // widest)
    return [(x * factor, y * factor) for x, y in polygon]


def any_vector(rng: Rng, reach: int) -> Point:
    """Return a vector other than zero with |x|, |y| <= reach."""
    while True:
        x, y = rng.several(2, -reach, reach)
        if x or y:
            return x, y


def any_move(rng: Rng, kind: str, far: int, robot: Polygon) -> Point:
    """Return a displacement of a kind in MOVES, with |dx|, |dy| <= about `far`."""
    if kind == "mixed":
        kind = rng.choice(("zero", "axis", "edge", "edge", "tiny", "primitive", "any", "any"))
    if kind == "zero":
        return 0, 0
    if kind == "tiny":
        return rng.choice(directions(1))
    if kind == "axis":
        length = rng.between(1, far)
        return rng.choice(((length, 0), (-length, 0), (0, length), (0, -length)))
    if kind == "edge":
        start = rng.below(len(robot))
        x, y = primitive(minus(robot[start], robot[start - 1]))
        most = max(1, far // max(abs(x), abs(y)))
        times = rng.between(1, most) * rng.choice((1, -1))
        return x * times, y * times
    vector = any_vector(rng, far)
    return primitive(vector) if kind == "primitive" else vector


def turns(rng: Rng, deciding: str, scenarios: int) -> list[str]:
    """Return who decides each scene; pairs: in half of them nobody, in half any."""
    if deciding != "pairs":
        return [deciding] * scenarios
    shuffled = [("none", "any")[number % 2] for number in range(scenarios)]
    rng.shuffle(shuffled)
    return shuffled


def fitting(make: Callable[[], S | None], tries: int, otherwise: str) -> S:
    """Return the first scene of `make` that is one (not None) and fits the world.

    Raises FamilyError with the message `otherwise` after so many tries.
    """
    for _ in range(tries):
        scenario = make()
        if scenario is not None and fits(scenario):
            return scenario
    raise FamilyError(otherwise)


def filled(
    rng: Rng,
    make: Callable[[], Scenario | None],
    *,
    vertices: int,
    scenarios: int,
    corner: bool | int,
) -> Iterator[Scenario]:
    """Yield the scenes of `make`, disguised, until a file has so many vertices or scenarios.

    If `make` gives up (None), or a scene does not fit the world, the next one is tried.
    corner: push each scene into a corner of the world, so that the limit is reached.
    Raises FamilyError after too many tries in a row.
    """
    tries = 0
    while scenarios > 0:
        tries += 1
        if tries > _MOST_TRIES:
            raise FamilyError(f"no scene fits the world in {_MOST_TRIES} tries; make it smaller")
        scenario = make()
        if scenario is None or not fits(scenario):
            continue
        vertices -= scenario.vertices
        scenarios -= 1
        if vertices < 0:
            return
        tries = 0
        yield settled(rng, disguised(rng, scenario), corner=bool(corner))
