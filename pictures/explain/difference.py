"""The Minkowski difference: the obstacle and the reflected sweep added, and the origin."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import groupby
from operator import itemgetter

import drawsvg

from gen.geometry import Point, cross
from pictures.explain.matter import Matter
from pictures.explain.scene import mark
from pictures.explain.view import Area, Number, View, axes, frame, framing
from pictures.minkowski import Edge, Source, merged, reflected
from pictures.moment import Contact

ROBOT, MOVE, OBSTACLE = "of-robot", "of-move", "of-obstacle"  # the looks of edges


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
    draw_edges(view, inside, [part for edge in edges for part in _lines(matter, edge)])
    ends = matter.ends()
    assert ends is not None
    (ax, ay), (bx, by) = ends
    hit = isinstance(matter.moment, Contact)
    mark(view, inside, (0, 0), (0, 0) if hit else (bx - ax, by - ay), hit=hit)
    if not hit:
        x, y = view.place(0, 0)
        inside.append(drawsvg.Circle(round(x, 1), round(y, 1), 6, class_="lens"))
    frame(view, group)


def draw_edges(
    view: View, group: drawsvg.Group, parts: Sequence[tuple[str, Sequence[tuple[Number, Number]]]]
) -> None:
    """Draw parts of a boundary in their looks, in their order: (look, [start, end])."""
    paths: dict[str, str] = {}
    for look, run in groupby(parts, key=itemgetter(0)):  # a run of edges is one line
        lines = [line for _, line in run]
        way = view.path([lines[0][0], *(end for _, end in lines)], closed=False)
        paths[look] = paths.get(look, "") + way
    for look, path in paths.items():
        group.append(drawsvg.Path(d=path, class_=look))


def _lines(matter: Matter, edge: Edge) -> Iterable[tuple[str, list[Point]]]:
    """Yield the parts of an edge with their looks: the obstacle's, the robot's, the move's."""
    along_move = matter.moves and cross(edge.way, matter.scenario.move) == 0
    for source, line in edge.parts():
        yield OBSTACLE if source is Source.FIRST else MOVE if along_move else ROBOT, line


def verdict(matter: Matter, edges: list[Edge]) -> str:
    """Return where the origin is. Whether it is on the boundary is only said if all is drawn."""
    if not isinstance(matter.moment, Contact):
        return "the origin is outside"
    if matter.is_complete and any(
        cross(edge.way, (-edge.start[0], -edge.start[1])) == 0 for edge in edges
    ):
        return "the origin is on its boundary"
    return "the origin is in it"
