"""Where two convex polygons face each other, or overlap: corners, edges, and points."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

from gen.geometry import Point, Polygon
from pictures.exact.extremes import Extremes
from pictures.exact.pair import first_touch
from pictures.exact.within import Container

ExactPoint = tuple[Fraction, Fraction]
Feature = tuple[Point, ...]  # a corner (one vertex), an edge (two), or nothing


def facing(
    robot: Extremes, obstacle: Extremes, toward: Point, shift: ExactPoint
) -> tuple[Feature, Feature, ExactPoint, ExactPoint]:
    """Return the parts that face each other along `toward`, and their nearest points.

    The robot is moved by `shift`; its part is returned unmoved, its point moved. Its part that is
    farthest along `toward` and the obstacle's nearest one are opposite each other at some point.
    Of edges that share more than a point, the middle of the shared part is taken.
    """
    wx, wy = toward

    def across(point: ExactPoint) -> Fraction:
        return wx * point[1] - wy * point[0]

    mine, its = robot.face(wx, wy), obstacle.face(-wx, -wy)
    here = sorted(((x + shift[0], y + shift[1]) for x, y in mine), key=across)
    there = sorted(((Fraction(x), Fraction(y)) for x, y in its), key=across)
    low = max(across(here[0]), across(there[0]))
    high = min(across(here[-1]), across(there[-1]))
    middle = (low + high) / 2
    my_point, its_point = (_point_at(ends, across, middle) for ends in (here, there))
    return (
        _least(mine, (my_point[0] - shift[0], my_point[1] - shift[1])),
        _least(its, its_point),
        my_point,
        its_point,
    )


def _point_at(
    ends: Sequence[ExactPoint], across: Callable[[ExactPoint], Fraction], level: Fraction
) -> ExactPoint:
    """Return the point of a segment (or of a single point) where `across` has a value."""
    (ax, ay), (bx, by) = ends[0], ends[-1]
    low, high = across(ends[0]), across(ends[-1])
    part = (level - low) / (high - low) if high > low else Fraction(0)
    return ax + part * (bx - ax), ay + part * (by - ay)


def _least(feature: Feature, point: ExactPoint) -> Feature:
    """Return the corner of a feature if the point is one, else all of it."""
    return next((((x, y),) for x, y in feature if x == point[0] and y == point[1]), feature)


def overlap_witness(robot: Polygon, obstacle: Polygon) -> tuple[Feature, Feature, ExactPoint]:
    """Return a corner of one inside the other, or two edges that cross, and the point.

    The polygons overlap, and neither lies within the other. The first corner of the robot is
    preferred, then of the obstacle.
    """
    for corner in Container(obstacle).inside(robot):
        return (corner,), (), (Fraction(corner[0]), Fraction(corner[1]))
    for corner in Container(robot).inside(obstacle):
        return (), (corner,), (Fraction(corner[0]), Fraction(corner[1]))
    extremes = Extremes(obstacle)
    for (ax, ay), (bx, by) in zip(robot, robot[1:] + robot[:1], strict=True):
        ux, uy = bx - ax, by - ay
        touch = first_touch(Extremes([(ax, ay)]), extremes, (ux, uy), Fraction(1))
        if touch and touch.toward:
            edge = extremes.face(-touch.toward[0], -touch.toward[1])
            return ((ax, ay), (bx, by)), edge, (ax + touch.time * ux, ay + touch.time * uy)
    raise ValueError("expected two polygons that overlap")
