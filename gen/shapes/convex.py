"""Shape constructors: counter-clockwise, strictly convex, anywhere near (0, 0)."""

from __future__ import annotations

from gen.geometry import Point, Polygon, cross, hull, primitive, step_right
from gen.rng import Rng
from gen.shapes.edges import angle_key, directions, from_edges, from_sorted_edges, reach_for


def in_box(rng: Rng, size: int, most: int) -> Polygon:
    """Return the hull of `most` random points of [0, size]^2: 3 to `most` vertices; size >= 1."""
    while True:
        corners = hull([(rng.between(0, size), rng.between(0, size)) for _ in range(most)])
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
    reach = reach_for(n * 4 // 3 + 8)
    by_length = sorted(directions(reach), key=lambda v: v[0] * v[0] + v[1] * v[1])
    choices = sorted(by_length[: n + n // 16 + 2], key=angle_key)
    while True:
        polygon = closed(rng.subset(choices, n - 1))
        if len(polygon) == n:
            return polygon


def arc(rng: Rng, n: int, reach: int = 0) -> Polygon:
    """Return a long thin polygon with exactly n vertices: n - 1 edges of one narrow cone.

    The cone is a sixteenth of the full turn; the last edge, by far the longest, closes.
    """
    reach = reach or reach_for(20 * n)
    choices = directions(reach)
    start = rng.below(len(choices))
    cone = (choices + choices)[start : start + max(n, len(choices) // 16)]
    return closed(rng.subset(cone, n - 1))


def many_gon(rng: Rng, edges: list[Point], n: int, stretch: int) -> Polygon:
    """Return a polygon with at most n vertices whose edges but one are parallel to given ones."""
    while True:
        chosen = rng.subset(edges, min(n - 1, len(edges)))
        lengths = [rng.between(1, stretch) for _ in chosen]
        polygon = closed(
            [(x * s, y * s) for (x, y), s in zip(map(primitive, chosen), lengths, strict=True)]
        )
        if len(polygon) >= 3:
            return polygon


def closed(edges: list[Point]) -> Polygon:
    """Return the polygon of the edges and the one that closes them; [] when they span no area.

    One vertex per edge, unless edges (the closing one included) share a direction.
    """
    sx, sy = sum(x for x, _ in edges), sum(y for _, y in edges)
    if (sx, sy) != (0, 0):
        edges = [*edges, (-sx, -sy)]
    if all(cross(edges[0], edge) == 0 for edge in edges):
        return []
    return from_edges(edges)


__all__ = [
    "arc",
    "box",
    "closed",
    "from_sorted_edges",
    "in_box",
    "many_gon",
    "near_circle",
    "needle",
    "random_convex",
]
