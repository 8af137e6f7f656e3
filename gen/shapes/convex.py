"""Shape constructors: counter-clockwise, strictly convex, anywhere near (0, 0)."""

from __future__ import annotations

from bisect import bisect_left
from functools import cache

from gen.geometry import Point, Polygon, hull, is_upper, primitive, step_right
from gen.rng import Rng
from gen.shapes.edges import (
    angle_key,
    closed,
    directions,
    directions_from,
    number_of_directions,
    reach_for,
)


def in_box(rng: Rng, size: int, most: int) -> Polygon:
    """Return the hull of `most` random points of [0, size]^2: 3 to `most` vertices; size >= 1."""
    while True:
        numbers = iter(rng.several(2 * most, 0, size))
        corners = hull(list(zip(numbers, numbers, strict=True)))
        if len(corners) >= 3:
            return corners


def box(width: int, height: int) -> Polygon:
    """Return an axis-parallel rectangle."""
    return [(0, 0), (width, 0), (width, height), (0, height)]


def needle(rng: Rng, along: Point) -> Polygon:
    """Return a triangle of area 1/2 whose longest edge is the primitive direction `along`.

    The third vertex lies on the next lattice line, as far along as fits.
    """
    right = step_right(along)
    left = (along[0] - right[0], along[1] - right[1])  # cross(along, left) == 1
    triangle = [(0, 0), along, left]
    return triangle if rng.chance(0.5) else [(-x, -y) for x, y in triangle]


def random_convex(rng: Rng, n: int, reach: int = 0, stretch: int = 1) -> Polygon:
    """Return a polygon with exactly n vertices, not symmetric.

    Edges are n - 1 random primitive directions with |x|, |y| <= reach (0: about twice
    as many to choose from as needed), each 1 to `stretch` times as long, and one that
    closes. O(n + reach^2) after the directions are known.
    """
    reach = reach or reach_for(2 * n)
    choices = directions(reach)
    while True:
        edges = rng.subset(choices, n - 1)
        if stretch > 1:
            edges = [(x * s, y * s) for x, y in edges for s in (1 + rng.below(stretch),)]
        polygon = closed(edges)
        if len(polygon) == n:
            return polygon


def near_circle(rng: Rng, n: int) -> Polygon:
    """Return a polygon with exactly n vertices and almost the smallest size possible.

    Its edges are the shortest primitive vectors, some left out at random, and one that
    closes. O(n log n).
    """
    choices = _shortest(n + n // 16 + 2, reach_for(n * 4 // 3 + 8))
    while True:
        polygon = closed(rng.subset(choices, n - 1))
        if len(polygon) == n:
            return polygon


@cache
def _shortest(count: int, reach: int) -> list[Point]:
    """Return the `count` shortest of the directions of a reach, by angle; of equals, the first."""
    choices = directions(reach)
    squares = [x * x + y * y for x, y in choices]
    ordered = sorted(squares)
    longest = ordered[count - 1]
    equals = count - bisect_left(ordered, longest)
    found = []
    for direction, square in zip(choices, squares, strict=True):
        if square < longest:
            found.append(direction)
        elif square == longest and equals:
            found.append(direction)
            equals -= 1
    return found


def arc(rng: Rng, n: int, reach: int = 0) -> Polygon:
    """Return a long thin polygon with exactly n vertices: n - 1 edges of one narrow cone.

    The cone is a sixteenth of the full turn; the last edge, by far the longest, closes.
    """
    reach = reach or reach_for(20 * n)
    total = number_of_directions(reach)
    start = rng.below(total)
    cone = directions_from(reach, start, max(n, total // 16))
    edges = rng.subset(cone, n - 1)
    if not is_upper(edges[0]):  # from 0 degrees on again, if the cone gets there
        zero = bisect_left(edges, True, key=is_upper)
        edges = edges[zero:] + edges[:zero]
    return closed(edges)


def many_gon(rng: Rng, edges: list[Point], n: int, stretch: int) -> Polygon:
    """Return a polygon with at most n vertices whose edges but one are parallel to given ones."""
    while True:
        chosen = rng.subset(edges, min(n - 1, len(edges)))
        lengths: dict[Point, int] = {}  # by direction, which several of the edges may share
        for direction in map(primitive, chosen):
            lengths[direction] = lengths.get(direction, 0) + rng.between(1, stretch)
        ordered = sorted(lengths, key=angle_key)
        polygon = closed([(x * s, y * s) for x, y in ordered for s in (lengths[x, y],)])
        if len(polygon) >= 3:
            return polygon
