"""Obstacles that touch a sweep or miss it by exactly one lattice line.

A line that supports the sweep along a primitive direction w carries lattice points
one w apart. The next lattice line outside is 1 / |w| away: an integer obstacle that
reaches it misses by as little as the grid permits, 5e-9 at the coordinate limit.
"""

from __future__ import annotations

from dataclasses import dataclass

from gen.geometry import (
    Point,
    Polygon,
    Sweep,
    cross,
    minus,
    primitive,
    step_right,
    sweep,
    translated,
)
from gen.rng import Rng

PLACES = ("start", "side", "end")


@dataclass(frozen=True)
class Support:
    """A line that supports a sweep, the sweep on its left.

    It meets the sweep exactly in base + s * along for real 0 <= s <= span.
    """

    base: Point
    along: Point  # primitive
    span: int  # 0: a single vertex


def edge_support(covered: Sweep, index: int) -> Support:
    """Return the line through the edge that leaves vertex `index`."""
    a, b = covered.edge(index)
    vector = minus(b, a)
    along = primitive(vector)
    return Support(a, along, (vector[0] // along[0]) if along[0] else vector[1] // along[1])


def vertex_support(rng: Rng, covered: Sweep, index: int) -> Support:
    """Return a random line that meets the sweep in vertex `index` only."""
    here = covered.vertices[index]
    back = minus(here, covered.vertices[index - 1])
    ahead = minus(covered.edge(index)[1], here)
    a, b = rng.between(1, 4), rng.between(1, 4)
    vector = (a * back[0] + b * ahead[0], a * back[1] + b * ahead[1])
    # A shorter vector nearby makes short obstacle edges possible; a long one is closer.
    shrink = 1 << rng.below(max(abs(vector[0]), abs(vector[1])).bit_length())
    shorter = (vector[0] // shrink, vector[1] // shrink)
    if shorter != (0, 0) and cross(back, shorter) > 0 and cross(shorter, ahead) > 0:
        vector = shorter
    return Support(here, primitive(vector), 0)


def indices(covered: Sweep, place: str) -> list[int]:
    """Return the vertices whose leaving edge belongs to a place: start, side or end.

    Without a move everything is the end. A place without an edge of its own (the robot
    shows only a vertex there) is empty.
    """
    n, front = len(covered.vertices), covered.front
    if front == 0:
        return list(range(n))
    if place == "start":
        return list(range(front - 1))
    if place == "side":
        return [front - 1, n - 1]
    return list(range(front, n - 1))


def random_support(rng: Rng, covered: Sweep, place: str) -> Support:
    """Return a line that supports the sweep in an edge or in one vertex, at a place."""
    edges = indices(covered, place)
    if edges and rng.chance(0.6):
        return edge_support(covered, rng.choice(edges))
    if edges:
        return vertex_support(rng, covered, rng.choice(edges))
    return vertex_support(rng, covered, 0 if place == "start" else covered.front)


@dataclass(frozen=True)
class Pair:
    """One obstacle twice: it touches the sweep; it misses it by one unit."""

    touching: Polygon
    missing: Polygon


def pair(rng: Rng, support: Support, shape: Polygon, *, flat: int) -> Pair:
    """Return the shape brought to a supporting line.

    flat: 0, the shape shows what it has there, mostly a vertex; h >= 1, it gets an edge
    of h lattice steps there (and the opposite one). It touches in the middle of the
    contact or at its very end; it misses by one lattice line, or stays on the line and
    misses by one lattice step.
    """
    along = support.along
    if flat:
        shape = sweep(shape, (-flat * along[0], -flat * along[1])).vertices
    nearest = max(cross(along, vertex) for vertex in shape)
    facing = [vertex for vertex in shape if cross(along, vertex) == nearest]
    low = min(facing, key=lambda v: along[0] * v[0] + along[1] * v[1])
    length = sum(map(abs, minus(facing[0], facing[-1]))) // sum(map(abs, along))
    s = rng.choice(
        (
            rng.between(-length, support.span),
            rng.between(min(0, support.span - length), max(0, support.span - length)),
            -length,
            support.span,
        )
    )
    touching = _put(shape, low, support, s)
    if rng.chance(0.3):
        beyond = support.span + 1 if rng.chance(0.5) else -length - 1
        return Pair(touching, _put(shape, low, support, beyond))
    x, y = step_right(along)
    if s == support.span and (s > 0 or 2 * (x * along[0] + y * along[1]) > _square(along)):
        x, y = x - along[0], y - along[1]  # the nearer point of the next line
    return Pair(touching, translated(touching, (x, y)))


def _square(v: Point) -> int:
    return v[0] * v[0] + v[1] * v[1]


def _put(shape: Polygon, vertex: Point, support: Support, s: int) -> Polygon:
    """Return the shape translated so that `vertex` lies s steps along the line."""
    (bx, by), (wx, wy) = support.base, support.along
    return translated(shape, (bx + s * wx - vertex[0], by + s * wy - vertex[1]))
