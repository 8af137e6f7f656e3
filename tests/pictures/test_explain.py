"""The picture that explains an answer."""

import doctest
import re
from math import cos, pi, sin
from xml.etree import ElementTree

import pytest

from gen.geometry import hull, translated
from gen.scenario import LIMIT, Scenario
from judge.kit.paths import DATA
from pictures.exact.extremes import Extremes
from pictures.explain import explain_picture, view
from pictures.explain.style import css
from pictures.explain.thin import KEPT_AROUND, thinned
from pictures.explain.view import Area, View, framing
from pictures.read import read_scenarios

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
TRIANGLE = [(8, 4), (9, 9), (7, 9)]
BUDGET = 300_000  # bytes
CHAR_PX = 0.5  # of the size of the letters: rather more than their average width


def texts(svg):
    return [
        element
        for element in ElementTree.fromstring(svg).iter()
        if element.tag.endswith("}text") and element.text
    ]


def words(svg):
    return " | ".join(element.text for element in texts(svg)).replace("\u00a0", " ")


def marks(svg, look):
    root = ElementTree.fromstring(svg)
    return sum(element.get("class") == look for element in root.iter())


def circle(size, radius, x=0, y=0):
    return hull(
        [
            (x + round(radius * cos(2 * pi * i / size)), y + round(radius * sin(2 * pi * i / size)))
            for i in range(size)
        ]
    )


def test_a_contact():
    svg = explain_picture(Scenario(SQUARE, (10, 0), [TRIANGLE]), answer="NO", found="YES")
    said = words(svg)
    assert "expected NO, found YES" in said
    assert "contact at (8, 4)" in said
    assert "the origin is on its boundary" in said
    assert "robot at t = 2/5" in said
    assert "that started at (4, 4) touches the corner (8, 4)" in said
    assert marks(svg, "hit") == 3  # in the scene, magnified, and the origin
    assert marks(svg, "gap") == 0


def test_a_clear_move():
    svg = explain_picture(Scenario(SQUARE, (10, 0), [translated(TRIANGLE, (0, 1))]))
    said = words(svg)
    assert "answer YES" in said
    assert "gap 1 |" in said
    assert "the origin is outside" in said
    assert marks(svg, "hit") == 0
    assert marks(svg, "gap") == 3


def test_no_obstacles():
    svg = explain_picture(Scenario(SQUARE, (3, 1), []))
    assert "There are no obstacles" in words(svg)
    assert marks(svg, "end") == 2  # and in the key


def test_one_unit_at_the_coordinate_limit():
    low = [(-LIMIT, -LIMIT), (LIMIT, LIMIT - 1), (-LIMIT, LIMIT)]
    robot = [(LIMIT - 2, -LIMIT), (LIMIT, -LIMIT), (LIMIT - 1, LIMIT - 2)]
    svg = explain_picture(Scenario(robot, (0, 0), [low]))
    said = words(svg)
    assert "e−9" in said
    assert re.search(r"Magnified \d × 10\S+ times", said)
    assert "gap 1/√79999999600000001 ≈ 3.54e-9" in said
    assert "−100\u2009000\u2009000" in said


@pytest.mark.parametrize("title", ["a <b> & 'c' \"d\"", "x" * 500, "a\x1b[2J\nb"])
def test_a_title_is_escaped_and_cut(title):
    svg = explain_picture(Scenario(SQUARE, (1, 0), [TRIANGLE]), answer="YES", title=title)
    heading = texts(svg)[0].text
    assert heading.isprintable()
    assert len(heading) <= 71
    if title.startswith("a <"):
        assert heading == title


def test_every_text_lies_within_the_picture():
    scenes = [
        Scenario(SQUARE, (10, 0), [TRIANGLE]),
        Scenario(
            [(-LIMIT, -LIMIT), (LIMIT, -LIMIT), (-LIMIT, 1 - LIMIT)], (0, 7), [circle(40, LIMIT)]
        ),
        Scenario(circle(50, 10**7, -80_000_000), (10**8, -5), [circle(60, 10**6)]),
    ]
    for scene in scenes:
        svg = explain_picture(scene, answer="YES", found="NO", title="a long name " * 9)
        width, height = (int(ElementTree.fromstring(svg).get(k)) for k in ("width", "height"))
        for element in texts(svg):
            size, x = float(element.get("font-size")), float(element.get("x"))
            reach = CHAR_PX * size * len(element.text.replace("\u2009", ""))
            before = {"middle": reach / 2, "end": reach}.get(element.get("text-anchor"), 0)
            assert x - before >= -2, element.text
            assert x - before + reach <= width + 12, element.text
            assert 0 < float(element.get("y")) < height


def test_pictures_in_one_page_do_not_disturb_each_other():
    scene = Scenario(SQUARE, (10, 0), [TRIANGLE])
    one, other = (explain_picture(scene, answer="NO", title=title) for title in "ab")
    ids = [set(re.findall(r'id="([^"]+)"', svg)) for svg in (one, other)]
    assert all(ids)
    assert not ids[0] & ids[1]
    for svg, own in ((one, ids[0]), (other, ids[1])):
        assert set(re.findall(r"url\(#([^)]+)\)", svg)) <= own
        scope = ElementTree.fromstring(svg).get("class")
        rules = re.findall(r"^(\S+) ", svg.split("<style>")[1].split("</style>")[0], re.MULTILINE)
        assert {rule.removeprefix("/*<![CDATA[*/") for rule in rules} == {f".{scope}", "@media"}


def lightness(colour):
    """Return L* of CIELAB, 0 to 100, of a colour such as #0072b2."""
    digits = colour.removeprefix("#")
    parts = [c * 2 for c in digits] if len(digits) == 3 else re.findall("..", digits)
    shares = [int(part, 16) / 255 for part in parts]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in shares]
    y = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    return 116 * y ** (1 / 3) - 16 if y > 0.008856 else 903.3 * y


@pytest.mark.parametrize("is_dark", [False, True])
@pytest.mark.parametrize(
    ("one", "other"),
    [("of-robot", "of-obstacle"), ("of-move", "of-obstacle"), ("then", "obstacle")],
)
def test_robot_and_obstacle_differ_without_colour(one, other, is_dark):
    """In lightness, from each other and from the page, and in their lines."""
    light, dark = css("x").split("@media")

    def found(look, what, text=dark if is_dark else light):
        return re.search(rf"\.x \.{look}{{[^}}]*\b{what}:([^;}}]+)", text)[1]

    shades = [lightness(found(look, "stroke")) for look in (one, other)]
    page = lightness(found("plot", "fill"))
    assert abs(shades[0] - shades[1]) >= 12
    assert all(abs(shade - page) >= 35 for shade in shades)
    dashes = [
        re.search(rf"\.x \.{look}{{[^}}]*dasharray:([^;}}]+)", light) for look in (one, other)
    ]
    assert len({dash and dash[1] for dash in dashes}) == 2


def test_crowds_and_large_polygons_stay_within_the_budget():
    crowd = [
        [(x, y), (x + 30, y), (x, y + 30)] for x in range(0, 6000, 40) for y in range(0, 4000, 40)
    ]
    large = [circle(500, 700, x, 9000) for x in range(0, 90_000, 1000)]
    for obstacles in (crowd, large):
        svg = explain_picture(Scenario(circle(3000, 2000, -6000), (900, 500), obstacles))
        assert len(svg.encode()) < BUDGET
        assert "Not everything is drawn" in words(svg)


def test_what_is_drawn_in_less_detail_is_said():
    svg = explain_picture(Scenario(circle(3000, 40_000), (9, 9), [circle(2500, 9000, 50_000)]))
    said = words(svg)
    assert re.search(r"the robot has \d+ of its [\d,]+ corners", said)
    assert re.search(r"obstacle 1 has \d+ of its [\d,]+ corners", said)
    svg = explain_picture(Scenario(SQUARE, (1, 0), [TRIANGLE, translated(SQUARE, (9999, 0))]))
    assert "1 obstacle lies outside this window" in words(svg)


def test_fewer_corners_keep_the_box_and_what_decides():
    polygon = circle(5000, 10**7)
    at = len(polygon) // 3
    few = thinned(Extremes(polygon), 36, [polygon[at]])
    assert len(few) <= 36 + 2 * KEPT_AROUND + 1
    assert few == [p for p in polygon if p in set(few)]
    assert set(polygon[at - KEPT_AROUND : at + KEPT_AROUND + 1]) <= set(few)
    for axis in (0, 1):
        for extreme in (min, max):
            assert extreme(p[axis] for p in few) == extreme(p[axis] for p in polygon)
    assert thinned(Extremes(SQUARE), 36) == SQUARE


def test_a_view_keeps_far_lines_near():
    shown = View(Area(0, 0, 100, 100), 0, 0, 10)
    path = shown.path([(-(10**9), -5), (10**9, -5), (5, 10**9)])
    assert all(abs(float(number)) < 1000 for number in re.findall(r"-?\d+\.?\d*", path))
    box = (99_999_990, -3, 10**8, 4)
    around = framing(Area(0, 0, 300, 200), box, 10)
    assert around.left <= box[0]
    assert box[2] <= around.right
    assert around.bottom <= box[1]
    assert box[3] <= around.top


def test_examples():
    assert doctest.testmod(view).failed == 0


@pytest.mark.slow
def test_the_samples_and_the_small_files():
    for file in [*DATA.glob("sample/*.in"), *DATA.glob("secret/*/*-huge.in")]:
        answers = file.with_suffix(".ans").read_text().split()
        for scenario, answer in list(zip(read_scenarios(file), answers, strict=True))[:40]:
            svg = explain_picture(scenario, title=file.name)
            assert len(svg.encode()) < BUDGET
            assert f"answer {answer}" in words(svg)


@pytest.mark.slow
def test_the_largest_files():
    for file in [*DATA.glob("secret/large/*.in"), *DATA.glob("secret/many/*.in")]:
        answer = file.with_suffix(".ans").read_text().split()[0]
        svg = explain_picture(read_scenarios(file)[0], title=file.name)
        assert len(svg.encode()) < BUDGET
        assert f"answer {answer}" in words(svg)
