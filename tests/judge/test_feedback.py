"""How much is told is the setter's to choose; every report obeys."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Literal

import pytest
from rich.console import Console

from judge.compare import Mismatch
from judge.feedback import Teller, told
from judge.kit.paths import PROBLEM_FILE
from judge.problem.cases import Case, case_at
from judge.problem.declaration import Feedback, SpecError, load
from judge.problem.verdict import Verdict
from judge.reports.html import to_html
from judge.reports.junit import to_junit
from judge.reports.schema import to_json
from judge.reports.terminal import live, print_report
from judge.results import CaseResult, GroupResult, Judging

from .test_explained import EXAMPLE, ILLUSTRATED, SCENE

Tell = Literal["verdict", "lessons", "counterexample"]
MISMATCH = Mismatch(77, 88, 99, "NO", "maybe")
SAMPLE, FIRST, SECOND, THIRD = (
    case_at(Path("/data"), name)
    for name in ("sample/first", "secret/small/alpha", "secret/small/beta", "secret/many/gamma")
)


def wrong(case: Case) -> CaseResult:
    return CaseResult(
        case, Verdict.WA, 0.5, 0.6, 9.0, str(MISMATCH), mismatch=MISMATCH, stderr="its words"
    )


RESULTS = (
    wrong(SAMPLE),
    CaseResult(FIRST, Verdict.AC, 0.5, 0.6, 9.0),
    wrong(SECOND),
    CaseResult(THIRD, Verdict.RTE, 0.5, 0.6, 9.0, "exit status 1: its words", stderr="its words"),
)
JUDGING = Judging(
    *("a.py", "Python 3", Verdict.WA, 0, 100, False, 5.0, 5.0, 512, None),
    (
        GroupResult("sample", Verdict.WA, 0, 0, True, RESULTS[:1]),
        GroupResult("small", Verdict.WA, 0, 15, True, RESULTS[1:3]),
        GroupResult("many", Verdict.RTE, 0, 20, True, RESULTS[3:]),
    ),
    diagnosis=ILLUSTRATED,
    counterexample=EXAMPLE,
    unexplained="search without success",
)


def reports(feedback: Feedback) -> dict[str, str]:
    """Return every report under this feedback, by name."""
    permitted = told(JUDGING, feedback)
    console = Console(width=200, markup=False, highlight=False)
    with console.capture() as captured:
        with live(console, feedback) as events:
            for result in JUDGING.cases:
                events.result(result)
        print_report(console, permitted, explain=True, verbose=True)
    return {
        "terminal": captured.get(),
        "json": to_json(permitted).decode(),
        "junit": to_junit(permitted).decode(),
        "html": to_html(permitted).decode(),
    }


def called(report: str, case: str) -> str:
    """Return what a report calls a case: in the page, the heading names the group."""
    return f'<th scope="row">{case.rpartition("/")[2]}</th>' if report == "html" else case


REPORTS = ["terminal", "json", "junit", "html"]


@pytest.mark.parametrize("name", REPORTS)
def test_everything_is_told_as_shipped(name: str) -> None:
    assert load().feedback == Feedback("counterexample", name_secret_cases=True)
    text = reports(load().feedback)[name]
    assert all(called(name, case) in text for case in ("secret/small/beta", "secret/many/gamma"))
    assert "scenario 77" in text
    assert "its words" in text
    if name != "junit":
        assert "Sentence number 4." in text
        assert "takes touching for free" in text
        assert EXAMPLE.sentence.partition("'")[2] in text.replace("&#39;", "'")
        assert (SCENE.sentence in text) is (name != "json")


@pytest.mark.parametrize("name", REPORTS)
@pytest.mark.parametrize("named", [True, False])
def test_only_the_verdict(name: str, named: bool) -> None:
    text = reports(Feedback("verdict", name_secret_cases=named))[name]
    for words in ("Sentence number", "touching for free", "corner (1, 0)", "its words", "(7, 8)"):
        assert words not in text
    assert not any(str(number) in text for number in (77, 88, 99))
    assert (called(name, "secret/small/beta") in text) is named
    assert "WA" in text


@pytest.mark.parametrize("name", REPORTS)
def test_lessons_without_a_counterexample(name: str) -> None:
    text = reports(Feedback("lessons", name_secret_cases=True))[name]
    assert "corner (1, 0)" not in text
    assert "(7, 8)" not in text
    assert "scene.svg" not in text
    assert "search without success" not in text
    assert "scenario 77" in text
    assert ("Sentence number 1." in text) is (name != "junit")


@pytest.mark.parametrize("name", REPORTS)
def test_secret_cases_without_names(name: str) -> None:
    text = reports(Feedback("counterexample", name_secret_cases=False))[name]
    for words in ("alpha", "beta", "gamma"):
        assert words not in text
    cases = ("sample/first", "secret/small/#2", "secret/many/#1")
    assert all(called(name, case) in text for case in cases)
    assert "scenario 77" in text, "a sample is no secret"
    assert "exit status 1" not in text, "the program's words may hold the input"
    if name == "json":
        assert text.count('"expected": "NO"') == 2  # of the sample, and of the counterexample


def test_a_secret_failure_has_no_files_and_no_place() -> None:
    secret_only = replace(JUDGING, groups=JUDGING.groups[1:], diagnosis=None, counterexample=None)
    console = Console(width=200, markup=False, highlight=False)
    with console.capture() as captured:
        feedback = Feedback("counterexample", name_secret_cases=False)
        print_report(console, told(secret_only, feedback), explain=True, verbose=True)
    text = captured.get()
    assert "first failure: WA on secret/small/#2\n" in text
    assert "  input" not in text
    assert "see it" not in text


def test_names_in_the_live_lines_are_those_of_the_report() -> None:
    feedback = Feedback("counterexample", name_secret_cases=False)
    teller = Teller(feedback)
    assert tuple(map(teller.result, JUDGING.cases)) == told(JUDGING, feedback).cases


@pytest.mark.parametrize("tell", ["nothing", "Verdict"])
def test_another_word_is_refused(tell: str, tmp_path: Path) -> None:
    path = tmp_path / "problem.toml"
    path.write_text(PROBLEM_FILE.read_text().replace('tell = "counterexample"', f'tell = "{tell}"'))
    with pytest.raises(SpecError, match=r"feedback\.tell"):
        load(path)
