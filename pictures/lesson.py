"""The figures of the lesson, docs/editorial.md: sums of polygons, step by step."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction

import drawsvg

from gen.geometry import Point, Polygon, sweep, translated
from pictures.explain.difference import draw_edges
from pictures.explain.scene import arrow, mark
from pictures.explain.style import FONT, css
from pictures.explain.view import Area, View, axes, frame, framing, write
from pictures.minkowski import Edge, Source, angle, merged, reflected

WIDTH = 680
PANEL_WIDTH, PANEL_HEIGHT = 176, 176
LEFT, TOP = 34, 30  # of a panel in its cell
CELL_WIDTH, CELL_HEIGHT = WIDTH / 3, 250
COLUMNS = 3

P = [(0, 0), (3, 0), (0, 2)]
Q = [(0, 0), (2, 0), (3, 2), (1, 3)]
ROBOT = [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]
MOVE = (4, 2)

Draw = Callable[[View, drawsvg.Group], None]
Panel = tuple[str, str, Draw]  # a heading, a line below, and what draws it


def lesson_figures() -> dict[str, str]:
    """Return the figures: name to SVG text."""
    return {"sum.svg": sum_figure(), "swept.svg": swept_figure(), "origin.svg": origin_figure()}


def sum_figure() -> str:
    """Draw the sum of two polygons: the edges in the order of their angles, one after the other."""
    edges = list(merged(P, Q))
    panels: list[Panel] = [
        ("P", "three edges", _polygon(P, "of-robot")),
        ("Q", "four edges", _polygon(Q, "of-obstacle")),
        ("all edges, by angle", "1 is one edge of each: equal angles", _fan(edges)),
    ]
    for i, edge in enumerate(edges, 1):
        owner = {Source.FIRST: "P", Source.SECOND: "Q", Source.BOTH: "P, then Q"}[edge.source]
        below = f"{owner}: {edge.way}, {angle(edge.way):.0f}°"
        panels.append((f"step {i}", below, _path(edges, i)))
    return _figure(
        "The sum of two convex polygons", panels, _box([e.start for e in edges], (-3, -3))
    )


def swept_figure() -> str:
    """Draw what a robot covers as a sum with a segment."""
    covered = sweep(ROBOT, MOVE)
    end = translated(ROBOT, MOVE)

    def segment(view: View, group: drawsvg.Group) -> None:
        arrow(group, view.place(0, 0), view.place(*MOVE))

    def whole(view: View, group: drawsvg.Group) -> None:
        group.append(drawsvg.Path(d=view.path(covered.vertices), class_="sweep"))
        group.append(drawsvg.Path(d=view.path(ROBOT), class_="start"))
        group.append(drawsvg.Path(d=view.path(end), class_="end"))
        sides = {covered.front - 1, len(covered.vertices) - 1}
        for i in range(len(covered.vertices)):
            line = view.path(covered.edge(i), closed=False)
            group.append(drawsvg.Path(d=line, class_="of-move" if i in sides else "of-robot"))

    panels: list[Panel] = [
        ("robot", "five edges", _polygon(ROBOT, "of-robot")),
        ("move", "a segment: two edges, there and back", segment),
        ("robot ⊕ move", "all that is covered on the way", whole),
    ]
    return _figure("The sweep is a sum", panels, _box(covered.vertices))


def origin_figure() -> str:
    """Draw an obstacle apart from a polygon, touching it and overlapping it, with differences."""
    still = [(0, 0), (3, 0), (0, 3)]
    shape = [(0, 0), (2, 0), (2, 2)]
    cases = {"apart": (3, 1), "touching": (2, 1), "overlapping": (1, 1)}
    panels: list[Panel] = [
        (name, f"Q at {place}", _pair(still, translated(shape, place)))
        for name, place in cases.items()
    ]
    wheres = ("outside: apart", "on the boundary: contact", "inside: contact")
    for where, place in zip(wheres, cases.values(), strict=True):
        edges = list(merged(reflected(still), translated(shape, place)))
        panels.append(("Q ⊕ (−P)", f"the origin is {where}", _difference(edges)))
    return _figure("Two polygons meet if and only if", panels, (-3, -3, 6, 4))


def _polygon(polygon: Polygon, look: str) -> Draw:
    def draw(view: View, group: drawsvg.Group) -> None:
        group.append(drawsvg.Path(d=view.path(polygon), class_="inner"))
        group.append(drawsvg.Path(d=view.path(polygon), class_=look))

    return draw


def _fan(edges: Sequence[Edge]) -> Draw:
    """Draw the edges as arrows from one point, numbered in the order of their angles."""

    def draw(view: View, group: drawsvg.Group) -> None:
        for i, edge in enumerate(edges, 1):
            x, y = edge.way
            look = _look(edge.source)
            arrow(group, view.place(0, 0), view.place(x, y), look, f"{look}-head")
            part = 1 + Fraction(5, 12) / max(abs(x), abs(y))
            px, py = view.place(x * part, y * part)
            write(group, str(i), px, py + 4, "text", anchor="middle")

    return draw


def _path(edges: Sequence[Edge], count: int) -> Draw:
    """Draw the sum's boundary as far as `count` edges."""

    def draw(view: View, group: drawsvg.Group) -> None:
        if count == len(edges):
            group.append(drawsvg.Path(d=view.path(e.start for e in edges), class_="inner"))
        draw_edges(view, group, [part for edge in edges[:count] for part in _parts(edge)])
        x, y = view.place(*edges[count - 1].end)
        group.append(drawsvg.Circle(round(x, 1), round(y, 1), 4, class_="hit-dot"))

    return draw


def _parts(edge: Edge) -> list[tuple[str, list[Point]]]:
    """Return the parts of a sum's edge with their looks."""
    return [(_look(source), line) for source, line in edge.parts()]


def _pair(p: Polygon, q: Polygon) -> Draw:
    def draw(view: View, group: drawsvg.Group) -> None:
        group.append(drawsvg.Path(d=view.path(p), class_="then"))
        group.append(drawsvg.Path(d=view.path(q), class_="obstacle"))

    return draw


def _difference(edges: Sequence[Edge]) -> Draw:
    def draw(view: View, group: drawsvg.Group) -> None:
        group.append(drawsvg.Path(d=view.path(e.start for e in edges), class_="inner"))
        draw_edges(view, group, [part for edge in edges for part in _parts(edge)])
        mark(view, group, (0, 0), (0, 0), hit=True)

    return draw


def _look(source: Source) -> str:
    return "of-obstacle" if source is Source.SECOND else "of-robot"


def _box(points: Sequence[Point], also: Point = (0, 0)) -> tuple[int, int, int, int]:
    xs, ys = zip(*points, also, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _figure(title: str, panels: Sequence[Panel], box: tuple[int, int, int, int]) -> str:
    """Return panels of equal scale, three in a row, as an SVG document."""
    rows = -(-len(panels) // COLUMNS)
    scope = "lesson-" + title.split()[-1]
    height = round(rows * CELL_HEIGHT + 4)
    drawing = drawsvg.Drawing(WIDTH, height, font_family=FONT, class_=scope, role="img")
    drawing.append_css(css(scope))
    drawing.append_title(title)
    drawing.append(drawsvg.Rectangle(0, 0, WIDTH, height, class_="paper"))
    for i, (heading, below, draw) in enumerate(panels):
        x, y = i % COLUMNS * CELL_WIDTH + LEFT, i // COLUMNS * CELL_HEIGHT + TOP
        area = Area(x, y, PANEL_WIDTH, PANEL_HEIGHT)
        view = framing(area, box, 14)
        group = drawsvg.Group()
        axes(view, group)
        draw(view, group)
        frame(view, group)
        write(group, heading, x, y - 8, "text", size=12.5)
        write(group, below, x, y + PANEL_HEIGHT + 30, "faint")
        drawing.append(group)
    text: str = drawing.as_svg(header="")
    return text + "\n"
