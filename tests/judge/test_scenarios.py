"""One scenario is found in an input file, and nothing is said about a file that is none."""

from __future__ import annotations

from pathlib import Path

import pytest

from gen.scenario import parse, render
from judge.kit.paths import DATA
from judge.problem.scenarios import scenario_lines

FILES = ["sample/04-notch", "secret/static/13-mixture", "secret/small/49-hundreds"]


@pytest.mark.parametrize("name", FILES)
def test_each_scenario_is_what_the_generator_reads(name: str) -> None:
    path = DATA / f"{name}.in"
    for number, scenario in enumerate(parse(path.read_bytes()), 1):
        lines = scenario_lines(path, number)
        assert lines is not None
        assert "\n".join(["1", *lines, ""]).encode() == render([scenario])
        assert number > 20 or scenario_lines(path, number) == lines
    assert scenario_lines(path, number + 1) is None
    assert scenario_lines(path, 0) is None


TRIANGLE = "3 0\n0 0\n0 0\n1 0\n0 1\n"


@pytest.mark.parametrize(
    "text",
    ["", "YES\n", "2\n", f"1\n{TRIANGLE[:-4]}", "1\n3 1\n0 0\n0 0\n1 0\n0 1\n", "1\n3\n", "\xff\n"],
)
def test_what_is_no_input_has_no_scenario(tmp_path: Path, text: str) -> None:
    path = tmp_path / "x.in"
    path.write_text(text)
    assert scenario_lines(path, 1) is None
    path.write_text(f"2\n{TRIANGLE}1 1 1\n")  # what comes later does not matter
    assert scenario_lines(path, 1) == TRIANGLE.split("\n")[:-1]
    assert scenario_lines(path, 2) is None
    assert scenario_lines(tmp_path / "none.in", 1) is None
