"""What several families of this room share: the width of the world, points beside a line."""

from __future__ import annotations

from gen.geometry import (
    Point,
    cross,
    minus,
)
from gen.rng import Rng
from gen.scenario import LIMIT

WIDTH = 2 * LIMIT


def point_beside(rng: Rng, along: Point, side: int) -> Point:
    """Return a point on a side (1 left, -1 right) of the line, about within its own extent."""
    while True:
        point = (
            rng.between(min(0, along[0]), max(0, along[0])),
            rng.between(-WIDTH + max(0, along[1]), WIDTH + min(0, along[1])),
        )
        if side * cross(along, point) > 0:
            return point


def far_point_beside(rng: Rng, along: Point, base: Point, side: int) -> Point:
    """Return a random point of the world on a side (1 left, -1 right) of a line, not near it."""
    while True:
        point = rng.between(0, WIDTH), rng.between(0, WIDTH)
        if side * cross(along, minus(point, base)) > WIDTH:
            return point
