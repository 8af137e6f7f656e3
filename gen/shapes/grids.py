"""Every strictly convex polygon on a small grid."""

from __future__ import annotations

from itertools import combinations

from gen.geometry import Polygon, hull


def grid_polygons(side: int) -> list[Polygon]:
    """Return every strictly convex polygon whose vertices lie on the side x side grid.

    Placed, not up to translation: 168 on the 3 x 3 grid. At most two vertices lie in
    each row, so no more than 2 * side are tried.
    """
    points = [(x, y) for x in range(side) for y in range(side)]
    return [
        polygon
        for n in range(3, 2 * side + 1)
        for chosen in combinations(points, n)
        if len(polygon := hull(list(chosen))) == n
    ]
