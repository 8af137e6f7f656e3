"""All strictly convex polygons on a small grid."""

from __future__ import annotations

from itertools import combinations

from gen.geometry import Polygon, hull


def grid_polygons(side: int) -> list[Polygon]:
    """Return every strictly convex polygon whose vertices lie on the side x side grid.

    side: points in a row, so coordinates are 0 .. side - 1. Polygons at different places are
    different: 168 on the 3 x 3 grid. Those with fewer vertices come first. A row holds at most
    two vertices of a strictly convex polygon, so sets of up to 2 * side points are tried.
    """
    points = [(x, y) for x in range(side) for y in range(side)]
    return [
        polygon
        for n in range(3, 2 * side + 1)
        for chosen in combinations(points, n)
        if len(polygon := hull(list(chosen))) == n
    ]
