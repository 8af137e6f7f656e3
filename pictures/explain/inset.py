"""The decisive place, magnified: its axes count from a grid point there."""

from __future__ import annotations

from fractions import Fraction
from math import sqrt

import drawsvg

from gen.geometry import Polygon
from pictures.cut import cut
from pictures.exact.meeting import ExactPoint
from pictures.explain.matter import Matter
from pictures.explain.scene import mark
from pictures.explain.thin import thinned
from pictures.explain.view import Area, View, axes, frame, path_of
from pictures.moment import Approach, Contact

GAPS_WIDE = 5  # the window, in gaps
EDGES_WIDE = 2.5  # the window, in the shortest of the edges that meet
LEAST_MAGNIFIED = 1.6
OTHERS_MAX, TRIED_MAX = 40, 200


def inset_view(matter: Matter, scene: View, area: Area) -> View | None:
    """Return the view of the decisive place; None if it would show no more than the scene."""
    ends = matter.ends()
    if ends is None or matter.moment is None or not (matter.moment.robot or matter.moment.feature):
        return None
    (ax, ay), (bx, by) = ends
    units = Fraction(EDGES_WIDE * _shortest_edge(matter)).limit_denominator(10**6)
    if isinstance(matter.moment, Approach):
        units = Fraction(GAPS_WIDE * sqrt(matter.moment.squared))
    units = min(units, Fraction(scene.right - scene.left) / 4)
    if area.width / float(units) < LEAST_MAGNIFIED * scene.scale:
        return None
    tall = units * Fraction(area.height / area.width)
    return View(area, (ax + bx) / 2 - units / 2, (ay + by) / 2 - tall / 2, units)


def _shortest_edge(matter: Matter) -> float:
    """Return the length of the shortest edge at the corners that meet, or of the edges."""
    assert matter.moment is not None
    lengths = []
    for polygon, feature in (
        (matter.robot, matter.moment.robot),
        (matter.obstacle, matter.moment.feature),
    ):
        for corner in feature or polygon[:1]:
            at = polygon.index(corner)
            for other in (polygon[at - 1], polygon[(at + 1) % len(polygon)]):
                lengths.append(sqrt((other[0] - corner[0]) ** 2 + (other[1] - corner[1]) ** 2))
    return min(lengths)


def reference(matter: Matter, view: View) -> ExactPoint:
    """Return the point from which the inset's axes count: a grid point if one is there."""
    ends = matter.ends()
    assert ends is not None
    for x, y in ends[::-1]:
        grid_x, grid_y = Fraction(round(x)), Fraction(round(y))
        if view.shows(grid_x, grid_y):
            return grid_x, grid_y
    return ends[1]


def draw_inset(matter: Matter, view: View, group: drawsvg.Group, clip: drawsvg.ClipPath) -> None:
    """Draw the robot at the decisive moment and the obstacles that are in the window."""
    axes(view, group, reference(matter, view), whole=False)
    inside = drawsvg.Group(clip_path=clip)
    group.append(inside)
    for polygon in _others(matter, view):
        _fill(view, inside, polygon, "other")
    _fill(view, inside, _cut(matter.robot_at(matter.time), view), "then")
    _fill(view, inside, _cut(_exact(matter.obstacle), view), "obstacle")
    ends = matter.ends()
    assert ends is not None
    mark(view, inside, *ends, hit=isinstance(matter.moment, Contact))
    frame(view, group)


def _others(matter: Matter, view: View) -> list[list[ExactPoint]]:
    """Return what the window shows of further obstacles."""
    assert matter.moment is not None
    near = [i for i in view.seen(matter.boxes) if i != matter.moment.obstacle]
    found: list[list[ExactPoint]] = []
    for i in near[:TRIED_MAX]:
        few = thinned(matter.bodies.obstacle(i), 120)
        seen = _cut(_exact(few), view)
        if seen:
            found.append(seen)
        if len(found) == OTHERS_MAX:
            break
    if len(found) == OTHERS_MAX or len(near) > TRIED_MAX:
        matter.notes.append(f"the magnified part shows only {len(found)} of the other obstacles")
    return found


def _exact(polygon: Polygon) -> list[ExactPoint]:
    return [(Fraction(x), Fraction(y)) for x, y in polygon]


def _fill(view: View, group: drawsvg.Group, polygon: list[ExactPoint], look: str) -> None:
    if polygon:
        path = path_of([view.place(x, y) for x, y in polygon])
        group.append(drawsvg.Path(d=path, class_=look))


def _cut(polygon: list[ExactPoint], view: View) -> list[ExactPoint]:
    """Return a convex polygon cut to the window and some more around it.

    Exact: it may be larger than the window by any factor.
    """
    more = Fraction(view.right - view.left) / 8
    bounds = (
        (0, 1, view.left - more),
        (0, -1, -view.right - more),
        (1, 1, view.bottom - more),
        (1, -1, -view.top - more),
    )
    for axis, sign, limit in bounds:
        heights = [sign * point[axis] - Fraction(limit) for point in polygon]
        polygon = cut(polygon, heights)
    return polygon
