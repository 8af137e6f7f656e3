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
    minus,
    primitive,
    step_right,
    sweep,
    translated,
)
from gen.rng import Rng

PLACES = ("start", "side", "end")


@dataclass(frozen=True, slots=True)
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
    here, there = covered.edge(index)
    back_x, back_y = minus(here, covered.vertices[index - 1])
    ahead_x, ahead_y = minus(there, here)
    a, b = rng.between(1, 4), rng.between(1, 4)
    x, y = a * back_x + b * ahead_x, a * back_y + b * ahead_y
    # A shorter vector nearby makes short obstacle edges possible; a long one is closer.
    shift = rng.below(max(abs(x), abs(y)).bit_length())
    short_x, short_y = x >> shift, y >> shift
    if back_x * short_y > back_y * short_x and short_x * ahead_y > short_y * ahead_x:
        x, y = short_x, short_y
    return Support(here, primitive((x, y)), 0)


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


@dataclass(frozen=True, slots=True)
class Pair:
    """One obstacle at two places: there it touches the sweep; there it misses it by one unit."""

    shape: Polygon
    to_touch: Point
    to_miss: Point

    @property
    def touching(self) -> Polygon:
        """The obstacle where it touches."""
        return translated(self.shape, self.to_touch)

    @property
    def missing(self) -> Polygon:
        """The obstacle where it misses."""
        return translated(self.shape, self.to_miss)


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
    (wx, wy), span = along, support.span
    levels = [wx * y - wy * x for x, y in shape]
    nearest = max(levels)
    low, length = shape[levels.index(nearest)], 0
    if levels.count(nearest) > 1:
        facing = [vertex for vertex, level in zip(shape, levels, strict=True) if level == nearest]
        low = min(facing, key=lambda v: wx * v[0] + wy * v[1])
        length = sum(map(abs, minus(facing[0], facing[-1]))) // (abs(wx) + abs(wy))
    slack = span - length
    s = rng.choice(
        (rng.between(-length, span), rng.between(min(0, slack), max(0, slack)), -length, span)
    )
    # The vector that brings `low` to the line's base, and s steps along.
    x, y = support.base[0] - low[0], support.base[1] - low[1]
    touch_x, touch_y = x + s * wx, y + s * wy
    if rng.chance(0.3):
        beyond = span + 1 if rng.chance(0.5) else -length - 1
        return Pair(shape, (touch_x, touch_y), (x + beyond * wx, y + beyond * wy))
    right_x, right_y = step_right(along)
    if s == span and (s > 0 or 2 * (right_x * wx + right_y * wy) > wx * wx + wy * wy):
        right_x, right_y = right_x - wx, right_y - wy  # the nearer point of the next line
    return Pair(shape, (touch_x, touch_y), (touch_x + right_x, touch_y + right_y))
