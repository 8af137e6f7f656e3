"""The Minkowski difference: the obstacle and the reflected sweep added, and the origin."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import groupby
from operator import itemgetter

import drawsvg

from gen.geometry import cross
from pictures.explain.matter import Matter
from pictures.explain.scene import mark
from pictures.explain.view import Area, Number, View, axes, frame, framing
from pictures.minkowski import Edge, Source, merged, reflected
from pictures.moment import Contact

_LOOKS = {"robot": "of-robot", "move": "of-move", "obstacle": "of-obstacle"}


def difference(matter: Matter) -> list[Edge]:
    """Return the edges of obstacle (+) -(sweep), with few corners: FIRST are the obstacle's."""
    return list(merged(matter.obstacle, reflected(matter.covered)))


def difference_view(edges: list[Edge], area: Area) -> View:
    """Return the view of the whole difference and of the origin."""
    xs, ys = zip(*(edge.start for edge in edges), strict=True)
    box = (min(0, *xs), min(0, *ys), max(0, *xs), max(0, *ys))
    return framing(area, box, 16)


def draw_difference(
    matter: Matter, edges: list[Edge], view: View, group: drawsvg.Group, clip: drawsvg.ClipPath
) -> None:
    """Draw the difference, its edges in the looks of their polygons, and the origin."""
    axes(view, group)
    inside = drawsvg.Group(clip_path=clip)
    group.append(inside)
    inside.append(drawsvg.Path(d=view.path(edge.start for edge in edges), class_="inner"))
    paths = dict.fromkeys(_LOOKS, "")
    parts = (part for edge in edges for part in _lines(matter, edge))
    for owner, run in groupby(parts, key=itemgetter(0)):  # a run of edges is one line
        lines = [line for _, line in run]
        paths[owner] += view.path([lines[0][0], *(end for _, end in lines)], closed=False)
    for owner, look in _LOOKS.items():
        if paths[owner]:
            inside.append(drawsvg.Path(d=paths[owner], class_=look))
    ends = matter.ends()
    assert ends is not None
    (ax, ay), (bx, by) = ends
    hit = isinstance(matter.moment, Contact)
    mark(view, inside, (0, 0), (0, 0) if hit else (bx - ax, by - ay), hit=hit)
    if not hit:
        x, y = view.place(0, 0)
        inside.append(drawsvg.Circle(round(x, 1), round(y, 1), 6, class_="lens"))
    frame(view, group)


def _lines(matter: Matter, edge: Edge) -> Iterable[tuple[str, list[tuple[Number, Number]]]]:
    """Yield the parts of an edge with their owners: the obstacle's, the robot's, the move's."""
    ours = edge.source is not Source.FIRST
    along_move = matter.moves and cross(edge.way, matter.scenario.move) == 0
    owner = "obstacle" if not ours else "move" if along_move else "robot"
    if edge.source is not Source.BOTH:
        yield owner, [edge.start, edge.end]
        return
    x, y = edge.start
    middle = x + Fraction(edge.way[0], 2), y + Fraction(edge.way[1], 2)
    yield "obstacle", [edge.start, middle]
    yield owner, [middle, edge.end]


def verdict(matter: Matter, edges: list[Edge]) -> str:
    """Return where the origin is. Whether it is on the boundary is only said if all is drawn."""
    if not isinstance(matter.moment, Contact):
        return "the origin is outside"
    if matter.is_complete and any(
        cross(edge.way, (-edge.start[0], -edge.start[1])) == 0 for edge in edges
    ):
        return "the origin is on its boundary"
    return "the origin is in it"
