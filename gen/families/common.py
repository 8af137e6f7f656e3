"""What the families share: shapes and moves of every kind, and filling a file."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from gen.geometry import Point, Polygon, minus, primitive
from gen.rng import Rng
from gen.scenario import Scenario, fits
from gen.shapes.convex import box, in_box, near_circle, needle, random_convex
from gen.shapes.edges import directions

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


def scaled_up(polygon: Polygon, size: int) -> Polygon:
    """Return the polygon enlarged by the largest integer that keeps it within `size`."""
    widest = max(max(axis) - min(axis) for axis in zip(*polygon, strict=True))
    factor = max(1, size // widest)
    return [(x * factor, y * factor) for x, y in polygon]


def any_vector(rng: Rng, reach: int) -> Point:
    """Return a vector other than zero with |x|, |y| <= reach."""
    while True:
        vector = rng.between(-reach, reach), rng.between(-reach, reach)
        if vector != (0, 0):
            return vector


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


def filled(make: Callable[[], Scenario], vertices: int, scenarios: int) -> Iterator[Scenario]:
    """Yield what `make` returns until a file is full: so many scenarios or vertices."""
    while scenarios > 0:
        scenario = make()
        vertices -= scenario.vertices
        scenarios -= 1
        if vertices < 0:
            return
        yield scenario


def until_fitting(make: Callable[[], Scenario]) -> Scenario:
    """Return the first scene of `make` that fits the coordinate limit after a translation."""
    while True:
        scenario = make()
        if fits(scenario):
            return scenario
