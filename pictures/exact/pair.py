"""When a moving robot first touches one obstacle, and how near it comes to it.

The robot, moved by v, shares a point with the obstacle if and only if v lies in the Minkowski
difference D = {q - r : q in the obstacle, r in the robot}, a convex polygon. So the first
contact is where the segment from the origin along the move enters D, and the gap is the
distance of that segment from D. D is never built: the vertex of D that is extreme in a
direction is the difference of two extreme vertices, and a few of those are enough.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from gen.geometry import Point
from pictures.exact.extremes import Extremes


@dataclass(frozen=True, slots=True)
class Touch:
    """The first moment of contact.

    toward: an integer vector from the robot to the obstacle; a line across it through the common
    point separates the two. None: their interiors overlap at the start.
    """

    time: Fraction
    toward: Point | None


@dataclass(frozen=True, slots=True)
class Gap:
    """How near the robot comes. toward: an integer vector along the shortest way to the obstacle.

    squared: the square of the distance.
    """

    squared: Fraction
    toward: Point


def nearest_vertex(robot: Extremes, obstacle: Extremes, wx: int, wy: int) -> Point:
    """Return a vertex (x, y) of D with the least wx * x + wy * y."""
    qx, qy = obstacle.polygon[obstacle.farthest(-wx, -wy)]
    rx, ry = robot.polygon[robot.farthest(wx, wy)]
    return qx - rx, qy - ry


def first_touch(robot: Extremes, obstacle: Extremes, move: Point, latest: Fraction) -> Touch | None:
    """Return the first contact at a time from 0 to `latest`, or None. latest <= 1.

    Exact. A handful of steps of O(log m + log n) each.
    """
    dx, dy = direction = move if move != (0, 0) else (1, 0)
    if move == (0, 0):
        latest = Fraction(0)
    left = nearest_vertex(robot, obstacle, dy, -dx)
    right = nearest_vertex(robot, obstacle, -dy, dx)
    left_side = dx * left[1] - dy * left[0]
    right_side = dx * right[1] - dy * right[0]
    if left_side < 0 or right_side > 0:
        return None
    entry = _entry(robot, obstacle, direction, (left, right), latest)
    if entry is None:
        return None
    if entry.time >= 0:
        return entry
    leave = _entry(robot, obstacle, (-dx, -dy), (right, left), Fraction(0))
    if leave is None:  # it was left before the start
        return None
    if leave.time == 0:
        return leave
    if left_side == 0:
        return Touch(Fraction(0), (dy, -dx))
    if right_side == 0:
        return Touch(Fraction(0), (-dy, dx))
    return Touch(Fraction(0), None)


def _entry(
    robot: Extremes,
    obstacle: Extremes,
    direction: Point,
    sides: tuple[Point, Point],
    latest: Fraction,
) -> Touch | None:
    """Return where the line through the origin along `direction` enters D, or None if later.

    sides: two points of D, on the left of the line and on the right; one may be on it. Each step
    moves one of them to a vertex of D that is nearer to where the line comes from.
    """
    dx, dy = direction
    late, whole = latest.numerator, latest.denominator
    (ax, ay), (bx, by) = sides
    while True:
        wx, wy = ay - by, bx - ax  # across the segment from b to a; forward along the line
        pace = wx * dx + wy * dy
        cx, cy = nearest_vertex(robot, obstacle, wx, wy)
        level = wx * cx + wy * cy
        if level * whole > late * pace:
            return None
        side = dx * cy - dy * cx
        if side == 0 or level == wx * ax + wy * ay:
            return Touch(Fraction(level, pace), (wx, wy))
        if side > 0:
            ax, ay = cx, cy
        else:
            bx, by = cx, cy


def gap(robot: Extremes, obstacle: Extremes, move: Point, most: Fraction | None) -> Gap | None:
    """Return how near the robot comes to an obstacle; 0 if it touches.

    None: at least as far as the square root of `most`. Exact. A handful of steps of
    O(log m + log n). Source: Gilbert, Johnson, Keerthi, A fast procedure for computing the
    distance between complex objects (1988).
    """
    dx, dy = move
    limit, whole = most.as_integer_ratio() if most is not None else (0, 0)
    (qx, qy), (rx, ry) = obstacle.polygon[0], robot.polygon[0]
    a: Point = (qx - rx, qy - ry)  # a vertex of D, swept backwards along the move,
    b: Point | None = None  # and another: the origin faces the segment between them
    wx, wy = a  # away from the origin, towards both
    while True:
        level = wx * a[0] + wy * a[1]
        length = wx * wx + wy * wy
        if level == 0:
            return Gap(Fraction(0), (wx, wy))
        cx, cy = nearest_vertex(robot, obstacle, wx, wy)
        if wx * dx + wy * dy > 0:  # the robot is nearer at the end of the move
            cx, cy = cx - dx, cy - dy
        least = wx * cx + wy * cy
        if least > 0 and whole and least * least * whole >= limit * length:
            return None
        if least == level:
            return Gap(Fraction(least * least, length), (wx, wy))
        ends = _facing_ends(a, b, (cx, cy))
        if ends is None:
            return Gap(Fraction(0), (wx, wy))
        a, b = ends
        wx, wy = a
        if b is not None:
            wx, wy = b[1] - a[1], a[0] - b[0]
            if wx * a[0] + wy * a[1] < 0:
                wx, wy = -wx, -wy


def _facing_ends(a: Point, b: Point | None, c: Point) -> tuple[Point, Point | None] | None:
    """Return the part of a triangle, or of a segment if b is None, that is nearest to the origin.

    It has the corner c: an edge, as both its ends, or c alone. None: the origin is inside.
    """
    cx, cy = c
    inside = True
    for end, third in ((a, b), (b, a)):
        if end is None:
            continue
        ux, uy = end[0] - cx, end[1] - cy
        if third is not None:
            side = uy * cx - ux * cy  # of the origin
            if side * (ux * (third[1] - cy) - uy * (third[0] - cx)) > 0:
                continue
        inside = False
        if ux * cx + uy * cy < 0:
            return end, c
    return None if inside else (c, None)
