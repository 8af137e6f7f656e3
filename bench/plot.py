"""Curves in panels with logarithmic axes, as SVG: told apart by colour, line and marker."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, floor, log10

import drawsvg

from pictures.explain.style import FONT
from pictures.explain.view import write

SIZE = 10.5  # of letters
WIDTH, HEIGHT = 680, 330
LEFT, TOP, BOTTOM = 46, 40, 62
GAP = 52  # between two panels
# Okabe and Ito's colours; of each, what is drawn on a dark page.
COLOURS = (("#d55e00", "#ff8a3c"), ("#0072b2", "#56b4e9"), ("#007a58", "#2fc79a"))
DASHES = ("2 3", "8 3 2 3", "none")
_RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True)
class Curve:
    """Points (x, y), both positive, and their name."""

    name: str
    xs: Sequence[float]
    ys: Sequence[float]


@dataclass(frozen=True)
class Panel:
    """Up to three curves with a common pair of axes."""

    title: str
    curves: Sequence[Curve]


class _Axes:
    """Logarithmic axes from a power of ten to a power of ten, in a rectangle of pixels."""

    def __init__(self, panels: Sequence[Panel], left: float, width: float) -> None:
        xs = [log10(x) for panel in panels for curve in panel.curves for x in curve.xs]
        ys = [log10(y) for panel in panels for curve in panel.curves for y in curve.ys]
        self.x = floor(min(xs)), ceil(max(xs))
        self.y = floor(min(ys)), ceil(max(ys))
        self.left, self.width, self.height = left, width, HEIGHT - TOP - BOTTOM

    def place(self, x: float, y: float) -> tuple[float, float]:
        """Return the pixel of a point."""
        (x0, x1), (y0, y1) = self.x, self.y
        part_x, part_y = (log10(x) - x0) / (x1 - x0), (log10(y) - y0) / (y1 - y0)
        return self.left + part_x * self.width, TOP + (1 - part_y) * self.height


def plot(panels: Sequence[Panel], title: str) -> str:
    """Return an SVG document with the panels side by side, on equal axes."""
    drawing = drawsvg.Drawing(WIDTH, HEIGHT, font_family=FONT, class_="plot", role="img")
    drawing.append_css(_css())
    drawing.append_title(title)
    drawing.append(drawsvg.Rectangle(0, 0, WIDTH, HEIGHT, class_="paper"))
    width = (WIDTH - LEFT - GAP * (len(panels) - 1) - 12) / len(panels)
    for i, panel in enumerate(panels):
        axes = _Axes(panels, LEFT + i * (width + GAP), width)
        _grid(drawing, axes)
        write(drawing, panel.title, axes.left, TOP - 12, "text", size=12)
        for kind, curve in enumerate(panel.curves):
            _curve(drawing, axes, curve, kind)
    write(drawing, "CPU s", 4, TOP - 12, "text", size=SIZE)
    text: str = drawing.as_svg(header="")
    return text + "\n"


def _grid(drawing: drawsvg.Drawing, axes: _Axes) -> None:
    for power in range(axes.x[0], axes.x[1] + 1):
        x, _ = axes.place(10**power, 10 ** axes.y[0])
        drawing.append(drawsvg.Line(x, TOP, x, TOP + axes.height, class_="grid"))
        number = f"10{str(power).translate(_RAISED)}"
        write(drawing, number, x, TOP + axes.height + 15, "text", size=SIZE, anchor="middle")
    for power in range(axes.y[0], axes.y[1] + 1):
        _, y = axes.place(10 ** axes.x[0], 10**power)
        drawing.append(drawsvg.Line(axes.left, y, axes.left + axes.width, y, class_="grid"))
        write(drawing, f"{10**power:g}", axes.left - 5, y + 4, "text", size=SIZE, anchor="end")


def _curve(drawing: drawsvg.Drawing, axes: _Axes, curve: Curve, kind: int) -> None:
    """Draw a curve, and its name in the key below."""
    places = [axes.place(x, y) for x, y in zip(curve.xs, curve.ys, strict=True)]
    path = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in places)
    drawing.append(drawsvg.Path(d=path, class_=f"line k{kind}", stroke_dasharray=DASHES[kind]))
    key_x, key_y = axes.left + kind * axes.width / 3, HEIGHT - 18.0
    for x, y in [*places, (key_x + 6, key_y - 4)]:
        drawing.append(drawsvg.Path(d=_marker(kind, x, y), class_=f"dot k{kind}"))
    write(drawing, curve.name, key_x + 15, key_y, "text", size=SIZE)


def _marker(kind: int, x: float, y: float) -> str:
    if kind == 0:
        return f"M{x - 4:.1f} {y - 4:.1f}h8v8h-8z"
    if kind == 1:
        return f"M{x:.1f} {y - 5:.1f}l5 9h-10z"
    return f"M{x - 4.5:.1f} {y:.1f}a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0 -9 0z"


def _css() -> str:
    def rules(shade: int) -> list[str]:
        paper, grid, text = (("#fff", "#ddd", "#222"), ("#15181c", "#353c44", "#e8e8e6"))[shade]
        kinds = [
            f".plot .line.k{i}{{stroke:{c[shade]}}} .plot .dot.k{i}{{fill:{c[shade]}}}"
            for i, c in enumerate(COLOURS)
        ]
        return [
            f".plot .paper{{fill:{paper}}} .plot .text{{fill:{text}}}",
            f".plot .grid{{stroke:{grid};stroke-width:.8}}",
            ".plot .line{fill:none;stroke-width:2}",
            *kinds,
        ]

    return "\n".join([*rules(0), "@media (prefers-color-scheme:dark){", *rules(1), "}"])
