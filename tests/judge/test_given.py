"""Test cases of a user: what is wrong with them is said before anything runs."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from judge.kit.paths import DATA, REFERENCE
from judge.problem.cases import CasesError, case_at
from judge.problem.data import load_data
from judge.problem.declaration import load
from judge.problem.given import check_given, make_answers

PROBLEM = load()
FREE = "3 0\n0 0\n0 0\n1 0\n0 1\n"
TWO = f"2\n{FREE}{FREE}"
Checker = Callable[..., CompletedProcess[str]]


def write(directory: Path, name: str, text: str, answers: str | None) -> None:
    case = case_at(directory, name)
    case.input.parent.mkdir(parents=True, exist_ok=True)
    case.input.write_bytes(text.encode())
    if answers is not None:
        case.answer.write_text(answers)


@pytest.mark.parametrize(
    ("text", "answers", "fault"),
    [
        (TWO.replace("0 1", "0 -1"), "YES\nYES\n", r"b\.in:5: robot, vertex 2: clockwise turn"),
        (TWO[:-4], "YES\nYES\n", r"b\.in:11: robot, vertex 3: expected two integers .* end of"),
        (TWO.replace("\n", "\r\n"), "YES\nYES\n", r"b\.in:1: .*found \\r\\n"),
        (TWO, "YES\n", r"b\.ans: expected 2 answers, as b\.in says, found 1"),
        (TWO, "YES YES\nYES\n", r"b\.ans: expected 2 answers, as b\.in says, found 3"),
        (TWO, "YES\nmaybe\n", r"b\.ans:2: expected YES or NO, found 'maybe'"),
        (TWO, "\x1b[2J\nYES\n", r"b\.ans:1: expected YES or NO, found '.*x1b\[2J'"),
    ],
)
def test_a_fault_of_the_directory(tmp_path: Path, text: str, answers: str, fault: str) -> None:
    write(tmp_path, "a", TWO, "YES\nyes\n")
    write(tmp_path, "b", text, answers)
    with pytest.raises(CasesError, match=fault):
        load_data(PROBLEM, tmp_path)


@pytest.mark.parametrize("text", ["YES\n", "1\n", "1 2\n3 4\n", "x\n1 2\n", "", "1\n2 3 4\n"])
def test_inputs_of_other_problems_are_nobodys_fault(tmp_path: Path, text: str) -> None:
    write(tmp_path, "a", text, "anything\n")
    assert len(load_data(PROBLEM, tmp_path).chosen) == 1


def test_the_kits_own_cases_fit(tmp_path: Path) -> None:
    shutil.copytree(DATA / "sample", tmp_path / "sample")
    cases = load_data(PROBLEM, tmp_path).chosen
    assert len(cases) == 4
    check_given(cases)


def test_only_the_chosen_cases_are_checked(tmp_path: Path) -> None:
    write(tmp_path, "secret/small/a", TWO, "YES\nYES\n")
    write(tmp_path, "secret/large/b", TWO, "YES\n")
    assert len(load_data(PROBLEM, tmp_path, groups=["small"]).chosen) == 1


def test_missing_answers_are_made_and_nothing_is_overwritten(tmp_path: Path) -> None:
    write(tmp_path, "a", TWO, None)
    write(tmp_path, "b", TWO, "NO\nNO\n")
    write(tmp_path, "deep/c", (DATA / "sample/04-notch.in").read_text(), None)
    with pytest.raises(CasesError, match=r"a\.ans: .*--make-answers .* missing"):
        load_data(PROBLEM, tmp_path)
    made = list(make_answers(tmp_path))
    assert made == [tmp_path / "a.ans", tmp_path / "deep/c.ans"]
    assert (tmp_path / "a.ans").read_text() == "YES\nYES\n"
    assert (tmp_path / "b.ans").read_text() == "NO\nNO\n"
    expected = (DATA / "sample/04-notch.ans").read_text()
    assert (tmp_path / "deep/c.ans").read_text() == expected
    assert list(make_answers(tmp_path)) == []
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        *("a.ans", "a.in", "b.ans", "b.in", "deep")
    ]


def test_no_answer_is_made_if_any_input_is_malformed(tmp_path: Path) -> None:
    write(tmp_path, "a", TWO, None)
    write(tmp_path, "b", "2\n", None)
    with pytest.raises(CasesError, match=r"b\.in:2: m k: expected two integers"):
        list(make_answers(tmp_path))
    assert not (tmp_path / "a.ans").exists()
    with pytest.raises(CasesError, match="the kit's own answers are built by 'make data'"):
        list(make_answers(DATA))


def test_from_the_command_line(checker: Checker, tmp_path: Path) -> None:
    cases = tmp_path / "cases"
    write(cases, "a", TWO, None)
    done = checker(REFERENCE, "--data", cases, "--make-answers")
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("answered by the reference: cases/a.ans\nAC ")
    (cases / "a.ans").write_text("NO\n")
    refused = checker(REFERENCE, "--data", cases)
    assert (refused.returncode, refused.stdout) == (2, "")
    assert "a.ans: expected 2 answers, as a.in says, found 1\n" in refused.stderr
    alone = checker(REFERENCE, "--make-answers")
    assert (alone.returncode, alone.stdout) == (2, "")
    assert "--make-answers: expected --data DIR, too" in alone.stderr
