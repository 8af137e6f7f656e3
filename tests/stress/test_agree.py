"""Comparing solvers: what agrees, what differs, what fails."""

import sys
from itertools import islice

import pytest

from gen.scenario import Scenario
from stress import __main__ as command
from stress import agree
from stress.worlds import random_scenarios, small_world

ALWAYS_YES = "import sys\nfor _ in range(int(sys.stdin.readline())): print('YES')\n"


def program(folder, text):
    path = folder / "program.py"
    path.write_text(text)
    return path


def test_reference_brute_force_and_textbook_agree_on_random_scenarios():
    found = agree.compare(random_scenarios(20261122, 20_000))
    assert found.disagreement is None
    assert found.scenarios == 20_000
    assert 5_000 < found.yes < 15_000  # both answers were put to the test


def test_reference_brute_force_and_textbook_agree_on_a_part_of_the_small_world():
    # `make stress` goes through all of it; here every 353rd (a prime: no pattern).
    found = agree.compare(islice(small_world(3, 2), 0, None, 353))
    assert found.disagreement is None
    assert found.scenarios == 19_989
    assert 1_000 < found.yes < 19_000


def test_a_difference_is_found_and_told(tmp_path):
    wrong = program(tmp_path, ALWAYS_YES)
    found = agree.compare(random_scenarios(1, 500), [agree.SOLVERS[0], wrong], batch=100)
    assert found.disagreement is not None
    assert found.disagreement.answers == {"solution.py": "NO", "program.py": "YES"}
    again = agree.compare([found.disagreement.scenario], [agree.SOLVERS[0], wrong])
    assert again.disagreement == found.disagreement


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("import sys; sys.exit(3)", "program.py: exit status 3"),
        ("1 / 0", "program.py: exit status 1 ZeroDivisionError: division by zero"),
        ("print('YES')", "program.py: expected 2 answers, found 1"),
    ],
)
def test_a_failing_solver_is_named(tmp_path, text, message):
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    with pytest.raises(agree.SolverError, match=message):
        agree.compare([Scenario(square, (0, 0), [])] * 2, [program(tmp_path, text)])


def test_the_command_keeps_the_scenario_and_exits_with_1(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(agree, "DISAGREEMENTS", tmp_path / "kept")
    wrong = program(tmp_path, ALWAYS_YES)
    arguments = ["stress", "random", "--seeds", "1", "--scenarios", "200"]
    solvers = ["--solver", str(agree.SOLVERS[0]), "--solver", str(wrong)]
    monkeypatch.setattr(sys, "argv", [*arguments, *solvers])
    assert command.main() == 1
    assert "solution.py: NO, program.py: YES" in capsys.readouterr().out
    kept = (tmp_path / "kept" / "stress-1.in").read_text()
    assert kept.startswith("1\n")
