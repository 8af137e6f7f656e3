"""The commands of bench: what they print, and which arguments they refuse."""

import json
from xml.etree import ElementTree

import pytest

from bench import cli, growth, launch_cost, under_load


def test_ratios_are_printed_case_by_case(capsys):
    assert cli.main(["sample/01-*", "sample/02-*", "--runs", "1"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == ["case", "sample/01-first", "sample/02-sweep"]
    assert all(float(line.split()[-1]) > 0 for line in lines[1:])


@pytest.mark.parametrize(
    ("command", "arguments", "message"),
    [
        (cli, "--runs 0", "--runs: expected a whole number of at least 1, found '0'"),
        (cli, "none/*", "bench: no test case matches 'none/*'"),
        (cli, "sample/01-* --program /none", "bench: /none: No such file or directory"),
        (cli, "growth --runs 0", "--runs: expected a whole number of at least 1, found '0'"),
        (cli, "growth --part 99999 --output /none", "bench growth: /none: no such directory"),
        (launch_cost, "--runs 0", "--runs: expected a whole number of at least 1, found '0'"),
        (under_load, "--judgings 0", "--judgings: expected a whole number of at least 1"),
        (under_load, "--program none.py", "fairness: none.py: no such file"),
    ],
)
def test_nonsense_is_refused_in_one_line(command, arguments, message, capsys):
    assert command.main(arguments.split()) == 2
    assert message in capsys.readouterr().err.splitlines()[-1]


def test_a_program_that_fails_is_named(tmp_path, capsys):
    program = tmp_path / "wrong.py"
    program.write_text("raise SystemExit(3)")
    assert cli.main(["sample/01-*", "--program", str(program)]) == 2
    assert "wrong.py: exit status 3 on " in capsys.readouterr().err


def test_growth_is_measured_and_drawn(tmp_path, capsys):
    assert cli.main(["growth", "--runs", "1", "--part", "100", "--output", str(tmp_path)]) == 0
    assert len(capsys.readouterr().out.splitlines()) == 6  # three methods, two experiments
    report = json.loads((tmp_path / "growth.json").read_text())
    assert {g["method"] for g in report["growth"]} == {"naive", "textbook", "reference"}
    svg = ElementTree.fromstring((tmp_path / "growth.svg").read_text())
    names = [element.text for element in svg.iter() if element.text and "n^" in element.text]
    assert len(names) == 6


def test_the_exponent_of_a_power():
    assert growth.exponent([10, 20, 40], [1.0, 8.0, 64.0]) == 3
