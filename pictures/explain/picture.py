"""The picture that explains an answer: the scene, the decisive place, the Minkowski difference."""

from __future__ import annotations

import hashlib
import re
import textwrap

import drawsvg

from gen.scenario import Scenario
from judge.kit.text import printable_name
from pictures.exact.bodies import Bodies
from pictures.exact.pause import collector_paused
from pictures.explain.difference import difference, difference_view, draw_difference, verdict
from pictures.explain.inset import draw_inset, inset_view, reference
from pictures.explain.matter import Matter
from pictures.explain.scene import draw_scene, scene_view
from pictures.explain.style import FONT, css
from pictures.explain.view import Area, View
from pictures.moment import Approach, Contact, decisive
from pictures.words import distance, equals, place, tell

WIDTH = 680
LEFT, RIGHT = 66, 12  # room for the numbers at the axes
LINE_PX = 17
LINE_CHARS = 104
_RAISED = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
TITLE_CHARS = 70
LOWER_PX = 230  # the height of the two lower plots


def explain_picture(
    scenario: Scenario, *, answer: str | None = None, found: str | None = None, title: str = ""
) -> str:
    """Return an SVG element that shows why the answer is what it is, to be saved or embedded.

    answer: the right one; None: take it from the decisive moment. found: what a program printed
    instead, if it is to be shown. title: one line; it is cut if it is long. Any text is escaped.
    Ids and rules of style begin with a name that depends on all that is given, so a page may hold
    many pictures. The element is 680 wide and scales; it follows the reader's choice of a light
    or dark page.
    Exact where numbers are shown. About a second and 200 KB at most, for any valid scenario.
    """
    with collector_paused():
        return _Picture(scenario, answer, found, title).svg()


class _Picture:
    def __init__(
        self, scenario: Scenario, answer: str | None, found: str | None, title: str
    ) -> None:
        bodies = Bodies(scenario)
        self.matter = Matter(bodies, decisive(scenario, bodies))
        self.heading = printable_name(title, TITLE_CHARS)
        if answer is None:
            answer = "NO" if isinstance(self.matter.moment, Contact) else "YES"
        self.answer = f"answer {answer}"
        if found is not None:
            self.answer = f"expected {answer}, found {printable_name(found, 20)}"
        some = [scenario.robot, *scenario.obstacles[:9]]
        known = (self.heading, self.answer, scenario.move, bodies.boxes[:9], [o[:9] for o in some])
        self.scope = "p" + hashlib.sha256(repr(known).encode()).hexdigest()[:10]
        self.body = drawsvg.Group()
        self.y = 0.0

    def svg(self) -> str:
        """Return the document."""
        matter = self.matter
        reason = tell(matter.scenario, matter.moment)
        self._heading()
        scene = self._scene()
        self._key()
        if matter.moment:
            self._lower(scene)
        self._caption(reason)
        height = round(self.y + 8)
        drawing = drawsvg.Drawing(
            WIDTH,
            height,
            font_family=FONT,
            class_=self.scope,
            role="img",
            style="max-width:100%;height:auto",
        )
        drawing.append_css(css(self.scope))
        drawing.append_title(
            f"{self.heading + ': ' if self.heading else ''}{self.answer}. {reason}"
        )
        drawing.append(drawsvg.Rectangle(0, 0, WIDTH, height, class_="paper"))
        drawing.append(self.body)
        text: str = drawing.as_svg(header="")
        return text + "\n"

    def _text(
        self, text: str, x: float, size: float = 12.5, look: str = "text", **style: str
    ) -> None:
        self.body.append(
            drawsvg.Text(
                text, size, x, round(self.y, 1), class_=look, xml__space="preserve", **style
            )
        )

    def _heading(self) -> None:
        self.y += 22
        self._text(self.heading or "Why?", 12, 14, font_weight="bold")
        self._text(self.answer, WIDTH - RIGHT, 14, font_weight="bold", text_anchor="end")
        self.y += 10

    def _clip(self, area: Area, name: str) -> drawsvg.ClipPath:
        clip = drawsvg.ClipPath(id=f"{self.scope}-{name}")
        clip.append(drawsvg.Rectangle(area.left, area.top, area.width, area.height))
        return clip

    def _scene(self) -> View:
        view = scene_view(self.matter, LEFT, self.y, WIDTH - LEFT - RIGHT)
        draw_scene(self.matter, view, self.body, self._clip(view.area, "scene"))
        self.y += view.area.height + 20
        return view

    def _key(self) -> None:
        """Say what the lines mean."""
        matter, moment = self.matter, self.matter.moment
        entries = []
        if not moment or matter.time > 0:
            entries.append(("start", "robot at the start"))
        if moment:
            when = f" at t {equals(matter.time)}" if matter.moves else ""
            entries.append(("then", f"robot{when}"))
        if matter.moves:
            entries += [("end", "robot at the end"), ("sweep", "covered on the way")]
        if moment:
            entries.append(("obstacle", f"obstacle {moment.obstacle + 1}, which decides"))
        if len(matter.boxes) > 1:
            entries.append(("other", "other obstacles"))
        x = 14.0
        self.y += 8
        for look, text in entries:
            need = 38 + 5.3 * len(text)
            if x + need > WIDTH:
                x, self.y = 14.0, self.y + LINE_PX
            self.body.append(drawsvg.Rectangle(x, round(self.y - 9, 1), 20, 10, class_=look))
            self._text(text, x + 25, 11, "faint")
            x += need
        self.y += 14

    def _lower(self, scene: View) -> None:
        """Draw the decisive place and the difference, side by side."""
        matter, moment = self.matter, self.matter.moment
        assert moment is not None
        self.y += 14
        top = self.y + 10
        half = WIDTH / 2
        inset = inset_view(matter, scene, Area(LEFT, top, half - LEFT - 8, LOWER_PX))
        edges = difference(matter)
        wide = Area(LEFT, top, WIDTH - LEFT - RIGHT, LOWER_PX)
        right = Area(half + LEFT, top, half - LEFT - RIGHT, LOWER_PX)
        area = right if inset else wide
        if inset:
            self._text(
                f"Magnified {_times(inset.scale / scene.scale)}", LEFT, 12, font_weight="bold"
            )
            draw_inset(matter, inset, self.body, self._clip(inset.area, "inset"))
            what = f"contact at {place(moment.point)}"
            if isinstance(moment, Approach):
                what = f"gap {distance(moment.squared)}"
            count = f"the axes count from {place(reference(matter, inset))}"
            self._below(LEFT, what, count)
        self._text(
            f"Minkowski difference of obstacle {moment.obstacle + 1}",
            area.left,
            12,
            font_weight="bold",
        )
        view = difference_view(edges, area)
        draw_difference(matter, edges, view, self.body, self._clip(area, "sum"))
        what = "sweep" if matter.moves else "robot"
        move = " move dotted," if matter.moves else ""
        self._below(
            area.left,
            f"obstacle ⊕ (−{what}): {verdict(matter, edges)}",
            f"edges: robot solid,{move} obstacle dash-dot",
        )
        self.y = top + LOWER_PX + 48

    def _below(self, x: float, *lines: str) -> None:
        """Write lines below a plot of the lower row; self.y is its heading."""
        for i, line in enumerate(lines):
            y = round(self.y + LOWER_PX + 40 + 14 * i, 1)
            self.body.append(drawsvg.Text(line, 11, x, y, class_="faint"))

    def _caption(self, reason: str) -> None:
        self.y += 8
        for line in textwrap.wrap(_kept_together(reason), LINE_CHARS):
            self.y += LINE_PX
            self._text(line, 14)
        if self.matter.notes:
            notes = "Not everything is drawn: " + "; ".join(dict.fromkeys(self.matter.notes)) + "."
            for line in textwrap.wrap(notes, LINE_CHARS + 14):
                self.y += LINE_PX - 2
                self._text(line, 14, 11, "faint")


def _times(factor: float) -> str:
    """Return how much larger, with long numbers as powers of ten: `3 × 10¹⁵ times`."""
    if factor < 1e6:
        return f"{factor:,.0f} times"
    digits, _, power = f"{factor:.0e}".partition("e+")
    return f"{digits} × 10{str(int(power)).translate(_RAISED)} times"


def _kept_together(text: str) -> str:
    """Return a text that is never broken within a point."""
    return re.sub(r"(\([^() ]+,) (?=[^() ]+\))", "\\1\u00a0", text)
