"""The whole scene: the robot at its start, at its end and at the decisive moment, and obstacles."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from math import ceil, floor

import drawsvg

from gen.geometry import Polygon
from gen.scenario import Box
from judge.kit.text import counted
from pictures.explain.matter import Matter
from pictures.explain.thin import thinned
from pictures.explain.view import Area, Number, Place, View, axes, clipped, frame, framing
from pictures.moment import Contact

CORNERS_MAX = 4000  # of all obstacles but the one that decides
SMALL_PX = 3.0  # a smaller obstacle is a dot
DOTS_MAX = 2500
NUMBERED_MAX = 12  # with more obstacles, only the one that decides gets its number
HEIGHTS_PX = (190, 360)  # the least and the greatest height of the scene
MARGIN_PX = 18.0  # free around what is shown
AROUND = 1.0  # of the size of what the robot covers, this much around it is shown


def scene_view(matter: Matter, left_px: float, top_px: float, width_px: float) -> View:
    """Return the view of what the robot covers, of the decisive place, and of what is around."""
    left, bottom, right, top = matter.covered_box
    ends = matter.ends()
    if ends:
        left, right = min(left, floor(ends[1][0])), max(right, ceil(ends[1][0]))
        bottom, top = min(bottom, floor(ends[1][1])), max(top, ceil(ends[1][1]))
    more = int(AROUND * max(right - left, top - bottom)) + 1
    lefts, bottoms, rights, tops = zip(matter.covered_box, *matter.boxes, strict=True)
    left, bottom = max(left - more, min(lefts)), max(bottom - more, min(bottoms))
    right, top = min(right + more, max(rights)), min(top + more, max(tops))
    fitting = (width_px - 2 * MARGIN_PX) * (top - bottom) / (right - left) + 2 * MARGIN_PX
    height_px = round(min(max(fitting, HEIGHTS_PX[0]), HEIGHTS_PX[1]))
    area = Area(left_px, top_px, width_px, height_px)
    return framing(area, (left, bottom, right, top), MARGIN_PX)


def draw_scene(matter: Matter, view: View, group: drawsvg.Group, clip: drawsvg.ClipPath) -> None:
    """Draw everything, from back to front."""
    axes(view, group)
    inside = drawsvg.Group(clip_path=clip)
    group.append(inside)
    inside.append(drawsvg.Path(d=view.path(matter.covered), class_="sweep"))
    _others(matter, view, inside)
    if matter.moment:
        inside.append(drawsvg.Path(d=view.path(matter.obstacle), class_="obstacle"))
    if matter.moves:
        inside.append(drawsvg.Path(d=view.path(matter.covered), class_="sweep-line"))
        inside.append(drawsvg.Path(d=view.path(matter.robot_at(Fraction(1))), class_="end"))
    if matter.time > 0 or not matter.moment:
        inside.append(drawsvg.Path(d=view.path(matter.robot), class_="start"))
    if matter.moment:
        then = matter.robot_at(matter.time)
        inside.append(drawsvg.Path(d=view.path(then), class_="then"))
    if matter.moves:
        _arrow(matter, view, inside)
    _mark(matter, view, inside)
    if matter.moment:
        _number(view, inside, matter.obstacle, matter.moment.obstacle + 1, "halo", 14)
    frame(view, group)


def _others(matter: Matter, view: View, group: drawsvg.Group) -> None:
    """Draw the obstacles that do not decide: the largest as polygons, the smallest as dots."""
    decisive = matter.moment.obstacle if matter.moment else -1
    seen = [i for i in view.seen(matter.boxes) if i != decisive]
    beyond = len(matter.boxes) - len(seen) - (decisive >= 0)
    sizes = dict(zip(seen, _pixels([matter.boxes[i] for i in seen], view), strict=True))
    large = sorted((i for i in seen if sizes[i] > SMALL_PX), key=lambda i: -sizes[i])
    corners, drawn, path = 0, 0, ""
    for i in large:
        directions = min(max(8, 4 * int(sizes[i] / 4)), 240)
        polygon = thinned(matter.bodies.obstacle(i), directions)
        if corners + len(polygon) > CORNERS_MAX:
            break
        corners, drawn = corners + len(polygon), drawn + 1
        path += view.path(polygon)
    if path:
        group.append(drawsvg.Path(d=path, class_="other"))
    dots = [i for i in seen if sizes[i] <= SMALL_PX] + large[drawn:]
    if dots:
        group.append(drawsvg.Path(d=_dots(matter.boxes, dots, view), class_="dots"))
        if len(large) > drawn or len(dots) > 50:
            obstacles = counted(len(dots), "obstacle")
            matter.notes.append(f"{obstacles} {'is a dot' if len(dots) == 1 else 'are dots'}")
    if beyond:
        are = "lies" if beyond == 1 else "lie"
        matter.notes.append(f"{counted(beyond, 'obstacle')} {are} outside this window")
    if len(matter.boxes) <= NUMBERED_MAX:
        for i in large[:drawn]:
            if sizes[i] > 16:
                _number(view, group, matter.scenario.obstacles[i], i + 1, "faint", 11)


def _pixels(boxes: list[Box], view: View) -> list[float]:
    """Return the longer sides of boxes."""
    scale = view.scale
    return [(c - a if c - a > d - b else d - b) * scale for a, b, c, d in boxes]


def _dots(boxes: list[Box], chosen: list[int], view: View) -> str:
    """Return small squares for obstacles, one for all in the same place."""
    x0, y0, scale, area = view.left, view.bottom, view.scale / 2, view.area
    x0, y0 = 2 * x0, 2 * y0
    places = [
        ((a + c - x0) * scale, (b + d - y0) * scale)
        for a, b, c, d in map(boxes.__getitem__, chosen)
    ]
    size = 2.0
    while True:
        cells = {(x // size, y // size) for x, y in places}
        if len(cells) <= DOTS_MAX:
            break
        size *= 1.5
    top = area.top + area.height
    squares = [
        f"M{area.left + i * size:.1f} {top - (j + 1) * size:.1f}h{size:g}v{size:g}h-{size:g}z"
        for i, j in sorted(cells)
    ]
    return "".join(squares)


def _number(
    view: View, group: drawsvg.Group, polygon: Polygon, number: int, look: str, size: int
) -> None:
    """Write an obstacle's number in the middle of what is seen of it."""
    area = view.area
    seen = clipped(
        [view.place(x, y) for x, y in polygon],
        Area(area.left + 50, area.top + 50, area.width - 100, area.height - 100),
    )
    if not seen:
        return
    xs, ys = zip(*seen, strict=True)
    x, y = _centre(seen)
    if max(max(xs) - min(xs), max(ys) - min(ys)) < 2 * size:  # beside it
        x, y = max(xs) + 8 + 0.3 * size * len(str(number)), min(ys) - 8
    group.append(
        drawsvg.Text(
            str(number),
            size,
            round(x, 1),
            round(y + size / 3, 1),
            text_anchor="middle",
            font_weight="bold",
            class_=look,
        )
    )


def _centre(places: list[Place]) -> Place:
    """Return the centre of gravity of a polygon in pixels."""
    ax, ay = places[0]
    area = x = y = 0.0
    for (bx, by), (cx, cy) in pairwise(places):
        part = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        area, x, y = area + part, x + part * (bx + cx - 2 * ax), y + part * (by + cy - 2 * ay)
    return (ax + x / area / 3, ay + y / area / 3) if abs(area) > 1 else places[len(places) // 2]


def _arrow(matter: Matter, view: View, group: drawsvg.Group) -> None:
    """Draw the move as an arrow from the middle of the robot's box at its start."""
    xs, ys = zip(*matter.robot, strict=True)
    dx, dy = matter.scenario.move
    x, y = Fraction(min(xs) + max(xs), 2), Fraction(min(ys) + max(ys), 2)
    start, end = view.place(x, y), view.place(x + dx, y + dy)
    arrow(group, start, end)


def arrow(
    group: drawsvg.Group, start: Place, end: Place, look: str = "arrow", head_look: str = "head"
) -> None:
    """Draw an arrow, unless it is too short to be seen."""
    ux, uy = end[0] - start[0], end[1] - start[1]
    length = (ux * ux + uy * uy) ** 0.5
    if length < 3:
        return
    ux, uy = ux / length, uy / length
    head = min(10.0, length)
    bx, by = end[0] - head * ux, end[1] - head * uy
    half = 0.4 * head
    group.append(drawsvg.Path(d=f"M{start[0]:.1f} {start[1]:.1f}L{bx:.1f} {by:.1f}", class_=look))
    tip = f"M{end[0]:.1f} {end[1]:.1f}L{bx - half * uy:.1f} {by + half * ux:.1f}"
    tip += f"L{bx + half * uy:.1f} {by - half * ux:.1f}Z"
    group.append(drawsvg.Path(d=tip, class_=head_look))


def _mark(matter: Matter, view: View, group: drawsvg.Group) -> None:
    """Mark the first contact with a target, or the closest approach with a dotted line."""
    ends = matter.ends()
    if ends is None:
        return
    mark(view, group, *ends, hit=isinstance(matter.moment, Contact))


def mark(
    view: View,
    group: drawsvg.Group,
    mine: tuple[Number, Number],
    its: tuple[Number, Number],
    *,
    hit: bool,
) -> None:
    """Mark two points and what is between them; with `hit`, they are one."""
    x, y = view.place(*its)
    if hit:
        group.append(drawsvg.Circle(round(x, 1), round(y, 1), 8, class_="hit"))
        group.append(drawsvg.Circle(round(x, 1), round(y, 1), 2.6, class_="hit-dot"))
        return
    a, b = view.place(*mine)
    group.append(drawsvg.Path(d=f"M{a:.1f} {b:.1f}L{x:.1f} {y:.1f}", class_="gap"))
    for px, py in ((a, b), (x, y)):
        group.append(drawsvg.Circle(round(px, 1), round(py, 1), 2.4, class_="text"))
