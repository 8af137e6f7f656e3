"""Pictures: where polygons overlap, and the command line."""

from fractions import Fraction
from xml.etree import ElementTree

import pytest

from gen.scenario import Scenario, render
from pictures import cli
from pictures.draw import picture
from pictures.overlap import overlap

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]


@pytest.mark.parametrize(
    ("other", "common"),
    [
        ([(5, 0), (9, 0), (9, 4)], set()),
        ([(4, 4), (9, 4), (9, 9)], {(4, 4)}),
        ([(4, 1), (9, 1), (4, 3)], {(4, 1), (4, 3)}),
        ([(1, 1), (2, 1), (1, 2)], {(1, 1), (2, 1), (1, 2)}),
        ([(-9, -9), (99, -9), (-9, 99)], set(SQUARE)),
        ([(3, 3), (7, 4), (4, 7)], {(3, 3), (4, Fraction(13, 4)), (4, 4), (Fraction(13, 4), 4)}),
    ],
)
def test_overlap_is_exact(other, common):
    assert set(overlap(SQUARE, other)) == common
    assert set(overlap(other, SQUARE)) == common


def test_a_picture_is_well_formed_and_marks_the_touching_point():
    scenario = Scenario(SQUARE, (10, 0), [[(8, 4), (9, 9), (7, 9)]])
    svg = picture([scenario, scenario], ["first & last", "<second>"])
    root = ElementTree.fromstring(svg)
    fills = [element.get("fill") for element in root.iter()]
    assert fills.count("#d1242f") == 2  # one red dot in each panel
    assert "first & last" in [element.text for element in root.iter()]


def run(*arguments):
    return cli.main([*map(str, arguments)])


def test_show_prints_one_scenario(capsys, tmp_path):
    file = tmp_path / "case.in"
    file.write_bytes(render([Scenario(SQUARE, (0, 0), [])] * 2))
    assert run("show", file, 2) == 0
    assert "case.in, scenario 2" in capsys.readouterr().out


def test_only_svg_is_written(capsys, tmp_path):
    file = tmp_path / "case.in"
    file.write_bytes(render([Scenario(SQUARE, (0, 0), [])]))
    assert run("show", file, 1, "-o", tmp_path / "q.png") == 2
    assert "q.png: expected a name that ends with .svg, found .png" in capsys.readouterr().err
    assert not (tmp_path / "q.png").exists()
    for name in ("q.svg", "q"):
        assert run("show", file, 1, "-o", tmp_path / name) == 0
        assert "</svg>" in (tmp_path / name).read_text()


@pytest.mark.parametrize(
    ("content", "number", "message"),
    [
        (b"1\n3 0\n0 0\n0 0\n1 0\n0 1\n", 2, "there is no scenario 2, expected 1 to 1"),
        (b"1\n3 0\n0 0\n0 0\n1 0\n0 1\n", 0, "there is no scenario 0"),
        (b"1\n3 0\n0 0\n0 0\n1 0\n", 1, "case.in:6: robot, vertex 3: expected two integers"),
        (b"1\n3", 1, "case.in:2: "),
        (b"", 1, "case.in:1: t: expected one integer, found the end of the file"),
        (b"\xff\x00", 1, "case.in:1: "),
        (b"1\n3 0\n0 0\n0 0\n0 1\n1 0\n", 1, "case.in:5: "),  # clockwise
        (None, 1, "cannot be read"),
    ],
)
def test_a_useless_file_gets_one_clear_line(capsys, tmp_path, content, number, message):
    file = tmp_path / "case.in"
    if content is not None:
        file.write_bytes(content)
    assert run("show", file, number) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert message in captured.err
    assert captured.err.count("\n") == 1


def test_figures_are_written_only_where_they_changed(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(cli, "sample_figures", lambda: {tmp_path / "a.svg": "<svg/>\n"})
    monkeypatch.setattr(cli, "lesson_figures", dict)
    monkeypatch.setattr(cli, "ROOT", tmp_path)
    assert run("figures", "--check") == 1
    assert not (tmp_path / "a.svg").exists()
    assert run("figures") == 0
    assert run("figures", "--check") == 0
    assert [path.name for path in tmp_path.iterdir()] == ["a.svg"]
    assert capsys.readouterr().out == ("a.svg is not current: run 'make figures'\ndrawn: a.svg\n")
