"""Draws scenarios as SVG, each in a panel of its own."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import drawsvg

from gen.geometry import Polygon, sweep, translated
from gen.scenario import Scenario, bounds
from pictures.overlap import overlap

PANEL_PX = 300  # the longer side of the scene
MARGIN_PX = 26
CAPTION_PX = 26
GRID_UNITS_MAX = 40  # a wider scene is drawn without its grid
OVERLAP_VERTICES_MAX = 2_000  # of one polygon; with more, the overlap is not drawn

ROBOT = "#1f5fa8"
SWEEP = "#cfe1f5"
OBSTACLE = "#8a8173"
OBSTACLE_FILL = "#d9d3c7"
HIT = "#d1242f"
GRID = "#e4e4e4"
TEXT = "#333333"
FONT = "Helvetica, Arial, sans-serif"


def picture(scenarios: Sequence[Scenario], captions: Sequence[str]) -> str:
    """Return an SVG document: the scenarios side by side on the same scale, with captions."""
    lefts, bottoms, rights, tops = zip(*map(bounds, scenarios), strict=True)
    frame = (min(lefts), min(bottoms), max(rights), max(tops))
    panels = [Panel(scenario, frame) for scenario in scenarios]
    width = sum(panel.width for panel in panels)
    height = max(panel.height for panel in panels) + CAPTION_PX
    drawing = drawsvg.Drawing(width, height, font_family=FONT)
    drawing.append_title(" · ".join(captions))
    drawing.append(drawsvg.Rectangle(0, 0, width, height, fill="white"))
    left = 0
    for panel, caption in zip(panels, captions, strict=True):
        group = drawsvg.Group(transform=f"translate({left},0)")
        panel.draw(group)
        group.append(
            drawsvg.Text(caption, 14, panel.width / 2, height - 9, fill=TEXT, text_anchor="middle")
        )
        drawing.append(group)
        left += panel.width
    svg: str = drawing.as_svg()
    return svg + "\n"


class Panel:
    """The drawing of one scenario in a frame (left, bottom, right, top) of grid units."""

    def __init__(self, scenario: Scenario, frame: tuple[int, int, int, int]) -> None:
        self.scenario = scenario
        self.left, self.bottom, self.right, self.top = frame
        self.units = max(self.right - self.left, self.top - self.bottom)
        self.scale = PANEL_PX / self.units
        self.width = round((self.right - self.left) * self.scale) + 2 * MARGIN_PX
        self.height = round((self.top - self.bottom) * self.scale) + 2 * MARGIN_PX

    def draw(self, group: drawsvg.Group) -> None:
        """Draw everything, from back to front."""
        robot, move = self.scenario.robot, self.scenario.move
        covered = sweep(robot, move).vertices
        if self.units <= GRID_UNITS_MAX:
            self._grid(group)
        self._polygon(group, covered, fill=SWEEP)
        for obstacle in self.scenario.obstacles:
            self._polygon(group, obstacle, fill=OBSTACLE_FILL, stroke=OBSTACLE, stroke_width=1.5)
        if move != (0, 0):
            self._polygon(group, covered, fill=SWEEP, fill_opacity=0.45)
            self._polygon(
                group,
                translated(robot, move),
                fill="none",
                stroke=ROBOT,
                stroke_width=1.5,
                stroke_dasharray="5 4",
            )
        self._polygon(group, robot, fill=ROBOT, fill_opacity=0.35, stroke=ROBOT, stroke_width=1.8)
        for obstacle in self.scenario.obstacles:
            if max(len(covered), len(obstacle)) <= OVERLAP_VERTICES_MAX:
                self._hit(group, overlap(covered, obstacle))
        if move != (0, 0):
            self._arrow(group)

    def _place(self, x: int | Fraction, y: int | Fraction) -> tuple[float, float]:
        """Return the pixel of a point: y grows upwards in the scene, downwards in SVG."""
        return (
            round(float(x - self.left) * self.scale + MARGIN_PX, 2),
            round(float(self.top - y) * self.scale + MARGIN_PX, 2),
        )

    def _grid(self, group: drawsvg.Group) -> None:
        step = 1 if self.units <= 12 else 5
        for x in range(self.left, self.right + 1):
            start, end = self._place(x, self.bottom), self._place(x, self.top)
            group.append(drawsvg.Line(*start, *end, stroke=GRID, stroke_width=0.7))
            if x % step == 0:
                self._number(group, x, start[0], start[1] + 14, "middle")
        for y in range(self.bottom, self.top + 1):
            start, end = self._place(self.left, y), self._place(self.right, y)
            group.append(drawsvg.Line(*start, *end, stroke=GRID, stroke_width=0.7))
            if y % step == 0:
                self._number(group, y, start[0] - 6, start[1] + 3.5, "end")

    @staticmethod
    def _number(group: drawsvg.Group, number: int, x: float, y: float, anchor: str) -> None:
        group.append(drawsvg.Text(str(number), 10, x, y, fill="#888888", text_anchor=anchor))

    def _polygon(
        self,
        group: drawsvg.Group,
        polygon: Polygon | list[tuple[Fraction, Fraction]],
        **style: str | float,
    ) -> None:
        coordinates = [c for x, y in polygon for c in self._place(x, y)]
        group.append(drawsvg.Lines(*coordinates, close=True, stroke_linejoin="round", **style))

    def _hit(self, group: drawsvg.Group, common: list[tuple[Fraction, Fraction]]) -> None:
        """Mark the points that the sweep and an obstacle have in common."""
        if len(common) == 1:
            group.append(drawsvg.Circle(*self._place(*common[0]), 4.5, fill=HIT))
        elif common:
            self._polygon(group, common, fill=HIT, fill_opacity=0.75, stroke=HIT, stroke_width=3)

    def _arrow(self, group: drawsvg.Group) -> None:
        """Draw the displacement as an arrow from the middle of the robot at its start."""
        robot, (dx, dy) = self.scenario.robot, self.scenario.move
        middle_x = Fraction(sum(x for x, _ in robot), len(robot))
        middle_y = Fraction(sum(y for _, y in robot), len(robot))
        start = self._place(middle_x, middle_y)
        end = self._place(middle_x + dx, middle_y + dy)
        group.append(drawsvg.Line(*start, *end, stroke=ROBOT, stroke_width=1.8))
        group.append(drawsvg.Circle(*start, 2.5, fill=ROBOT))
        length = ((end[0] - start[0]) ** 2 + (end[1] - start[1]) ** 2) ** 0.5 or 1.0
        ux, uy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
        head = [
            end,
            (end[0] - 10 * ux - 4 * uy, end[1] - 10 * uy + 4 * ux),
            (end[0] - 10 * ux + 4 * uy, end[1] - 10 * uy - 4 * ux),
        ]
        coordinates = [round(c, 2) for point in head for c in point]
        group.append(drawsvg.Lines(*coordinates, close=True, fill=ROBOT))
