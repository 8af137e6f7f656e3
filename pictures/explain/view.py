"""A window on the plane, drawn in an area of the picture, with axes and a 1-2-5 grid."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import ceil, floor, log10

import drawsvg

from gen.scenario import Box
from pictures.cut import cut

Number = int | Fraction
Place = tuple[float, float]  # pixels
LABEL_PX = 10
THIN_SPACE = "\u2009"
FAR_PX = 40.0  # so far outside its area a line may be cut off


@dataclass(frozen=True, slots=True)
class Area:
    """A rectangle of the picture, in pixels; y grows downwards."""

    left: float
    top: float
    width: float
    height: float


class View:
    """A window (left, bottom, units wide) in an area, on the same scale in x and y."""

    def __init__(self, area: Area, left: Number, bottom: Number, units: Number) -> None:
        self.area, self.left, self.bottom = area, left, bottom
        self.scale = area.width / float(units)  # pixels per unit
        self.right = left + units
        self.top = bottom + Fraction(area.height / self.scale)

    def place(self, x: Number, y: Number) -> Place:
        """Return the pixel of a point: y grows upwards in the plane, downwards in the picture."""
        area = self.area
        return (
            area.left + float(x - self.left) * self.scale,
            area.top + area.height - float(y - self.bottom) * self.scale,
        )

    def path(self, points: Iterable[tuple[Number, Number]], *, closed: bool = True) -> str:
        """Return the SVG path of a polygon or of a line; parts far outside are cut off."""
        places = [self.place(x, y) for x, y in points]
        if not closed:
            return path_of(places, closed=False)
        area = self.area
        if any(
            not (area.left - FAR_PX <= x <= area.left + area.width + FAR_PX)
            or not (area.top - FAR_PX <= y <= area.top + area.height + FAR_PX)
            for x, y in places
        ):
            places = clipped(places, area)
        return path_of(places)

    def seen(self, boxes: Sequence[Box]) -> list[int]:
        """Return the indices of the boxes that have a part in the window, or close to it."""
        left, bottom, right, top = (
            *(floor(self.left), floor(self.bottom)),
            *(ceil(self.right), ceil(self.top)),
        )
        return [
            i
            for i, (a, b, c, d) in enumerate(boxes)
            if c >= left and a <= right and d >= bottom and b <= top
        ]

    def shows(self, x: Number, y: Number) -> bool:
        """Tell whether a point is in the window."""
        return self.left <= x <= self.right and self.bottom <= y <= self.top


def path_of(places: Sequence[Place], *, closed: bool = True) -> str:
    """Return the SVG path through some pixels."""
    if not places:
        return ""
    shown = [f"{x:.1f} {y:.1f}".replace(".0", "") for x, y in places]
    shown = [a for i, a in enumerate(shown) if i == 0 or a != shown[i - 1]]
    return "M" + "L".join(shown) + ("Z" if closed else "")


def clipped(places: Sequence[Place], area: Area) -> list[Place]:
    """Return a convex polygon cut to an area and a margin around it; in pixels, to be drawn.

    Source: Sutherland and Hodgman, Reentrant polygon clipping (1974).
    """
    left, top = area.left - FAR_PX, area.top - FAR_PX
    right, bottom = area.left + area.width + FAR_PX, area.top + area.height + FAR_PX
    kept = list(places)
    for axis, sign, limit in ((0, 1, left), (0, -1, -right), (1, 1, top), (1, -1, -bottom)):
        heights = [sign * place[axis] - limit for place in kept]
        kept = cut(kept, heights)
    return kept


def framing(area: Area, box: Sequence[Number], margin: float) -> View:
    """Return the view of a box (left, bottom, right, top) in the middle of an area.

    margin: pixels that stay free around it.
    """
    left, bottom, right, top = box
    width, height = right - left, top - bottom
    inner_width, inner_height = area.width - 2 * margin, area.height - 2 * margin
    scale = min(inner_width / float(width or 1), inner_height / float(height or 1))
    units = Fraction(area.width / scale)
    x = left + Fraction(width) / 2 - units / 2
    y = bottom + Fraction(height) / 2 - Fraction(area.height / scale) / 2
    if units > 50:  # whole numbers are subtracted faster
        return View(area, floor(x), floor(y), ceil(units))
    return View(area, x, y, units)


def nice_step(least: float) -> Fraction:
    """Return the least 1, 2 or 5 times a power of ten that is not below `least`.

    >>> nice_step(0.03), nice_step(7)
    (Fraction(1, 20), Fraction(10, 1))
    """
    power = Fraction(10) ** floor(log10(least))
    return next(f * power for f in (1, 2, 5, 10) if float(f * power) >= least * (1 - 1e-9))


def axes(
    view: View, group: drawsvg.Group, origin: tuple[Number, Number] = (0, 0), *, whole: bool = True
) -> None:
    """Draw the grid, the frame and the numbers of a view.

    origin: the point from which the axes count. whole: lines at whole numbers only.
    """
    area = view.area
    least = 9 / view.scale
    fine = max(nice_step(least), Fraction(1)) if whole else nice_step(least)
    digits = max(len(_label(v, fine)) for v in (view.left - origin[0], view.right - origin[0]))
    step = max(nice_step((digits * 5.0 + 10) / view.scale), fine)
    tall = max(nice_step(26 / view.scale), fine)
    group.append(drawsvg.Rectangle(area.left, area.top, area.width, area.height, class_="plot"))
    lines = {"grid": "", "tick": "", "zero": ""}
    for x in _multiples(view.left, view.right, fine, origin[0]):
        px = view.place(x, view.bottom)[0]
        name = "zero" if x == 0 else "tick" if (x - origin[0]) % step == 0 else "grid"
        lines[name] += f"M{px:.1f} {area.top:.1f}v{area.height:.1f}"
    for y in _multiples(view.bottom, view.top, fine, origin[1]):
        py = view.place(view.left, y)[1]
        name = "zero" if y == 0 else "tick" if (y - origin[1]) % tall == 0 else "grid"
        lines[name] += f"M{area.left:.1f} {py:.1f}h{area.width:.1f}"
    for name, line in lines.items():
        if line:
            group.append(drawsvg.Path(d=line, class_=name))
    for x in _multiples(view.left, view.right, step, origin[0]):
        px = view.place(x, view.bottom)[0]
        text = _label(x - origin[0], step)
        if area.left + 6 <= px <= area.left + area.width + 8 - 2.9 * len(text):
            write(
                group,
                text,
                px,
                area.top + area.height + 13,
                "faint",
                size=LABEL_PX,
                anchor="middle",
            )
    for y in _multiples(view.bottom, view.top, tall, origin[1]):
        py = view.place(view.left, y)[1]
        if area.top + 4 <= py <= area.top + area.height - 2:
            write(
                group,
                _label(y - origin[1], tall),
                area.left - 5,
                py + 3.5,
                "faint",
                size=LABEL_PX,
                anchor="end",
            )


def frame(view: View, group: drawsvg.Group) -> None:
    """Draw the frame of a view, to be done last."""
    area = view.area
    group.append(drawsvg.Rectangle(area.left, area.top, area.width, area.height, class_="frame"))


def _multiples(low: Number, high: Number, step: Fraction, origin: Number) -> list[Fraction]:
    first, last = ceil((low - origin) / step), floor((high - origin) / step)
    return [origin + i * step for i in range(first, last + 1)]


def _label(value: Number, step: Fraction) -> str:
    """Return the number at a line of a grid; below 10^-3 in powers of ten."""
    if value == 0:
        return "0"
    if step >= 1:
        return f"{floor(value):,}".replace("-", "−").replace(",", THIN_SPACE)
    return f"{float(value):.6g}".replace("-", "−").replace("e−0", "e−")


def write(
    group: drawsvg.DrawingParentElement,
    text: str,
    x: float,
    y: float,
    look: str,
    *,
    size: float = 11,
    anchor: str = "start",
) -> None:
    """Write a line of text at a pixel."""
    group.append(
        drawsvg.Text(text, size, round(x, 1), round(y, 1), class_=look, text_anchor=anchor)
    )
