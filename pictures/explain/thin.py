"""Polygons of many corners in less detail: all that can be seen stays, and all that decides."""

from __future__ import annotations

from collections.abc import Iterable
from math import cos, pi, sin

from gen.geometry import Point, Polygon
from pictures.exact.extremes import Extremes

KEPT_AROUND = 30  # corners before and after one that decides
_FINE = 1 << 20


def thinned(extremes: Extremes, directions: int, keep: Iterable[Point] = ()) -> Polygon:
    """Return the corners that are farthest in evenly spread directions, and those near `keep`.

    The polygon itself if it has no more corners than that. The result lies inside it; its box is
    the same, and around the corners `keep` nothing differs. O(directions * log n).
    """
    polygon = extremes.polygon
    n = len(polygon)
    if n <= directions:
        return polygon
    chosen = {
        extremes.farthest(
            round(_FINE * cos(2 * pi * i / directions)), round(_FINE * sin(2 * pi * i / directions))
        )
        for i in range(directions)
    }
    for corner in keep:
        at = polygon.index(corner)
        chosen.update((at + i) % n for i in range(-KEPT_AROUND, KEPT_AROUND + 1))
    return [polygon[i] for i in sorted(chosen)]
