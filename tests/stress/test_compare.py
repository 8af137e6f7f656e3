"""Comparing programs: what agrees, what differs, what fails."""

import pytest

from gen.scenario import Scenario, render
from judge.kit.trusted import ProgramError, python_command
from stress import cli, compare
from stress.chance import random_files
from stress.compare import File, NothingComparedError, Program
from stress.programs import PYTHON
from stress.worlds import grid_world

ALWAYS_YES = "import sys\nfor _ in range(int(sys.stdin.readline())): print('YES')\n"
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
ALONE = Scenario(SQUARE, (0, 0), [])
PROGRAMS = [Program(path.name, python_command(path)) for path in PYTHON]


@pytest.fixture
def program(tmp_path):
    def make(text, every=1):
        path = tmp_path / "program.py"
        path.write_text(text)
        return Program(path.name, python_command(path), every)

    return make


def agreed(files, programs=PROGRAMS):
    return compare.compare(files, programs, jobs=2)


@pytest.mark.parametrize("scenarios", [5_000, pytest.param(20_000, marks=pytest.mark.slow)])
def test_reference_brute_force_and_textbook_agree_on_random_scenarios(scenarios):
    found = agreed(random_files(20261122, scenarios))
    assert found.disagreement is None
    assert found.scenarios == scenarios
    assert found.answered == (scenarios,) * 3
    assert 1 / 4 < found.yes / scenarios < 3 / 4  # both answers were put to the test


def test_reference_brute_force_and_textbook_agree_on_parts_of_the_small_world():
    # `make stress` goes through all of it; here 100 parts, evenly spread.
    world = grid_world(3, 2)
    parts = [world.file(start, 200) for start in range(0, world.size, world.size // 100)]
    together = b"".join(part.content.partition(b"\n")[2] for part in parts)
    count = sum(part.scenarios for part in parts)
    found = agreed([File(b"%d\n" % count + together, count)])
    assert found.disagreement is None
    assert found.scenarios == count >= 20_000
    assert 1_000 < found.yes < 19_000


def test_the_first_difference_is_found_and_told(program):
    both = [PROGRAMS[0], program(ALWAYS_YES)]
    found = agreed(random_files(1, 500), both)
    assert found.disagreement is not None
    assert found.disagreement.answers == (("solution.py", "NO"), ("program.py", "YES"))
    assert (found.scenarios, found.yes) == (2, 1)  # the first scenario's answer is YES
    again = agreed([File(render([found.disagreement.scenario]), 1)], both)
    assert again.disagreement == found.disagreement


def test_white_space_is_no_difference(program):
    lines = program("import sys\nprint(*['YES'] * int(sys.stdin.readline()))\n")
    other = program(ALWAYS_YES)
    assert agreed([File(render([ALONE] * 3), 3)], [other, lines]).disagreement is None


def test_a_program_may_answer_some_files_only(program):
    files = [File(render([ALONE] * n), n) for n in (5, 7, 11, 13)]
    found = agreed(files, [PROGRAMS[0], program(ALWAYS_YES, every=3)])
    assert found.answered == (36, 18)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("import sys; sys.exit(3)", "program.py: exit status 3"),
        ("1 / 0", "program.py: exit status 1: ZeroDivisionError: division by zero"),
        ("print('YES')", "program.py: expected 2 answers, found 1"),
        ("print('YES no')", "program.py: expected YES or NO, found 'no'"),
    ],
)
def test_a_failing_program_is_named(program, text, message):
    with pytest.raises(ProgramError, match=message):
        agreed([File(render([ALONE] * 2), 2)], [program(text)])


def test_agreement_on_nothing_is_an_error():
    with pytest.raises(NothingComparedError):
        agreed([])


def test_the_command_keeps_the_scenario_and_exits_with_1(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(compare, "DISAGREEMENTS", tmp_path / "kept")
    wrong = tmp_path / "program.py"
    wrong.write_text(ALWAYS_YES)
    arguments = ["random", "--seeds", "1", "--scenarios", "200", "--solver", str(wrong)]
    assert cli.main(arguments) == 1  # one program alone is compared with the reference
    assert "solution.py: NO, program.py: YES" in capsys.readouterr().out
    assert cli.main([*arguments, "--solver", str(PYTHON[0])]) == 1
    (kept,) = (tmp_path / "kept").iterdir()  # the same scenario: the same file
    assert kept.read_text().startswith("1\n")


def test_no_kept_scenario_replaces_another(tmp_path, monkeypatch):
    monkeypatch.setattr(compare, "DISAGREEMENTS", tmp_path / "kept")
    moves = ((0, 0), (1, 0), (0, 1))
    found = [compare.Disagreement(Scenario(SQUARE, move, []), ()) for move in moves]
    first, second = map(compare.keep, found[:2])
    first.unlink()
    assert compare.keep(found[2]) not in (first, second)
    assert len(list((tmp_path / "kept").iterdir())) == 2


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("random --scenarios -1", "--scenarios: expected a whole number of at least 1, found '-1'"),
        ("random --seeds 0", "--seeds: expected a whole number of at least 1, found '0'"),
        ("world --side 0", "--side: expected a whole number of at least 2, found '0'"),
        ("world --reach -1", "--reach: expected a whole number of at least 0, found '-1'"),
        ("complete --grids 5 2 1", "--grids: expected 2 to 4 points a side, found 5"),
        ("complete --grids 2 2 -1", "--grids: expected a whole number of at least 0, found '-1'"),
        ("complete --jobs 0", "--jobs: expected a whole number of at least 1, found '0'"),
        ("random --solver none.py", "none.py: no such file"),
    ],
)
def test_nonsense_is_refused_in_one_line(arguments, message, capsys):
    assert cli.main(arguments.split()) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.endswith(f"{message}\n")
