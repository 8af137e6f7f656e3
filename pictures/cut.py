"""One step of clipping: a convex polygon cut along a line."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TypeVar

T = TypeVar("T", float, Fraction)


def cut(points: Sequence[tuple[T, T]], heights: Sequence[T]) -> list[tuple[T, T]]:
    """Return the part of a convex polygon that is not below a line. O(n).

    heights: of each point over the line. Source: Sutherland and Hodgman, Reentrant polygon
    clipping, 1974.
    """
    kept: list[tuple[T, T]] = []
    for i, (x, y) in enumerate(points):
        before, here = heights[i - 1], heights[i]
        if before * here < 0:
            px, py = points[i - 1]
            part = before / (before - here)
            kept.append((px + part * (x - px), py + part * (y - py)))
        if here >= 0:
            kept.append((x, y))
    return kept
