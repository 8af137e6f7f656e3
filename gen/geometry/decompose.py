"""Cutting simple polygons into strictly convex pieces."""

from __future__ import annotations

from gen.geometry import Point, Polygon, cross, is_strictly_convex, minus


def convex_pieces(polygon: Polygon) -> list[Polygon]:
    """Return strictly convex pieces that together cover a simple polygon exactly.

    polygon: counter-clockwise, simple, no three consecutive vertices on a line; O(n^3).
    Ears are cut off; then neighbours are merged while the result stays strictly convex.
    Source: Hertel, Mehlhorn, Fast triangulation of simple polygons (1983).
    """
    pieces = _triangles(polygon)
    merged = True
    while merged:
        merged = False
        for i, one in enumerate(pieces):
            for j in range(i + 1, len(pieces)):
                joined = _joined(one, pieces[j])
                if joined is not None:
                    pieces[i] = joined
                    del pieces[j]
                    merged = True
                    break
            if merged:
                break
    return pieces


def _triangles(polygon: Polygon) -> list[Polygon]:
    """Cut off ears until a triangle is left. Corners that became straight are dropped."""
    rest = list(polygon)
    triangles: list[Polygon] = []
    while len(rest) > 3:
        for i in range(len(rest)):
            a, b, c = rest[i - 1], rest[i], rest[(i + 1) % len(rest)]
            if _turn(a, b, c) > 0 and not any(
                _in_triangle(p, a, b, c) for p in rest if p not in (a, b, c)
            ):
                triangles.append([a, b, c])
                del rest[i]
                break
        else:
            raise ValueError("convex_pieces: expected a simple counter-clockwise polygon")
    triangles.append(rest)
    return triangles


def _joined(one: Polygon, other: Polygon) -> Polygon | None:
    """Return the union of two pieces with a common edge if it is strictly convex, else None."""
    for i, a in enumerate(one):
        b = one[(i + 1) % len(one)]
        if b in other and other[(other.index(b) + 1) % len(other)] == a:
            at = other.index(a)
            union = one[i + 1 :] + one[: i + 1] + (other[at:] + other[:at])[1:-1]
            return union if is_strictly_convex(union) else None
    return None


def _turn(a: Point, b: Point, c: Point) -> int:
    return cross(minus(b, a), minus(c, b))


def _in_triangle(p: Point, a: Point, b: Point, c: Point) -> bool:
    """Tell whether p lies in the closed triangle."""
    return _turn(a, b, p) >= 0 and _turn(b, c, p) >= 0 and _turn(c, a, p) >= 0
