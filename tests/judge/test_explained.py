"""Why a program is not accepted, as the terminal says it."""

from __future__ import annotations

import os
import re
import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from rich.console import Console
from rich.text import Text

from judge.cli import Explainers, main
from judge.compare import Mismatch
from judge.explanation import Counterexample, Diagnosis, FailedScene, Like, MissedLesson
from judge.judging import Search
from judge.kit.paths import DATA
from judge.problem.cases import Case, case_at
from judge.problem.verdict import Verdict
from judge.reports import words
from judge.reports.explained import print_explained
from judge.reports.html import to_html
from judge.reports.terminal import print_report
from judge.results import CaseResult, GroupResult, Judging

from .conftest import WRONG

LESSONS = tuple(
    MissedLesson(f"lesson-{n}", f"Sentence number {n}.", (f"scene-{n}", f"other-{n}"))
    for n in range(1, 5)
)
DIAGNOSIS = Diagnosis(
    LESSONS,
    Like("wrong_answer/strict_touch.py", "takes touching for free"),
    "A remark.",
    scenes=96,
    wrong=12,
)
EXAMPLE = Counterexample(
    input="1\n3 1\n0 0\n0 0\n1 0\n0 1\n3\n1 0\n2 0\n2 1\n",
    expected="NO",
    found="YES",
    scenarios=1,
    obstacles=1,
    vertices=6,
    sentence="the robot's corner (1, 0) is the obstacle's corner.",
    seconds=1.25,
    steps=("seed 7 repeats this search",),
)
SCENE = FailedScene(
    *("scene-4", EXAMPLE.input, "NO", "no answer"),
    sentence="The edge (7, 8)–(9, 9) is touched.",
    picture="<svg>scene</svg>",
    file=Path("/kept/scene-4.in"),
)
ILLUSTRATED = replace(DIAGNOSIS, lessons=(*LESSONS[:3], replace(LESSONS[3], scene=SCENE)))
SMALL = "1\n3 0\n0 0\n0 0\n1 0\n0 1\n"
Source = Callable[[str, str], Path]


def failed(case: Case, found: str | None = "YES", **changes: object) -> Judging:
    """A judging whose only case is answered wrongly in scenario 1."""
    mismatch = Mismatch(1, 1, 1, "NO", found)
    result = CaseResult(case, Verdict.WA, 0.1, 0.1, 9.0, str(mismatch), mismatch=mismatch)
    result = replace(result, **changes)  # type: ignore[arg-type] # fields by name
    assert result.verdict is not None
    group = GroupResult(case.group, result.verdict, 0, 15, True, (result,))
    return Judging(
        *("a.py", "Python 3", result.verdict, 0, 100, True, 5.0, 5.0, 512, None, (group,))
    )


def said(judging: Judging, *, explain: bool = False, verbose: bool = False) -> str:
    console = Console(width=80, markup=False, highlight=False)
    with console.capture() as captured:
        print_explained(console, judging, Text("WA"), explain=explain, verbose=verbose)
    return captured.get()


@pytest.fixture
def case(tmp_path: Path) -> Case:
    found = case_at(tmp_path, "one")
    found.input.write_text(SMALL)
    return found


def test_a_short_scenario_is_printed_to_paste(case: Case) -> None:
    assert f"scenario 1 as an input of its own:\n{SMALL}" in said(failed(case))
    case.input.write_text(SMALL.replace("3 0", "12 0") + "9 9\n" * 9)
    text = said(failed(case))
    assert "of its own" not in text
    assert "see it" in text


def test_a_picture_is_offered_only_where_it_helps(case: Case) -> None:
    assert "see it" in said(failed(case))
    for found in (None, "maybe", "1"):  # not about one scenario
        assert "see it" not in said(failed(case, found))
    assert "see it" not in said(failed(case, verdict=Verdict.TLE, mismatch=None))
    kept = replace(EXAMPLE, file=case.input.with_name("kept.in"))
    text = said(replace(failed(case), counterexample=kept))
    assert text.count("see it") == 1
    assert re.search(r"see it  python3 \S*pictures show \S*/kept\.in 1 -o", text)
    case.input.write_text("YES\n")  # no input of this problem
    text = said(failed(case))
    assert "see it" not in text
    assert "of its own" not in text


def test_a_kit_that_cannot_draw_offers_no_picture(
    case: Case, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(words, "PICTURES", tmp_path / "none")
    assert "see it" not in said(failed(case))
    assert b"picture" not in to_html(failed(case))


def test_the_most_telling_lessons_and_all_on_request(case: Case) -> None:
    judging = replace(failed(case), diagnosis=DIAGNOSIS)
    text = said(judging)
    assert "it answers 12 of the 96 tiny scenes of the gallery wrongly" in text
    assert re.findall(r"\d\. Sentence number (\d)\.", text) == ["1", "2", "3"]
    assert "(1 more: --explain)" in text
    assert "exactly like a program that takes touching for free" in text
    assert "A remark." in text
    assert "scene-1" not in text
    text = said(judging, explain=True)
    assert re.findall(r"\d\. Sentence number (\d)\.", text) == ["1", "2", "3", "4"]
    assert "scenes: scene-4, other-4" in text
    quiet = said(replace(judging, diagnosis=Diagnosis((), None, "Only size is left.", 96, 0)))
    assert "Only size is left." in quiet
    assert "gallery" not in quiet


def test_the_scene_of_a_lesson_only_on_request(case: Case) -> None:
    judging = replace(failed(case), diagnosis=ILLUSTRATED)
    assert SCENE.input not in said(judging)
    text = said(judging, explain=True)
    assert (
        f"     scene-4:\n{SCENE.input}     expected NO, found no answer\n     {SCENE.sentence}\n"
        "     picture /kept/scene-4.svg\n"
    ) in text
    assert "#gallery=scene-4\n" in text
    assert "/kept/scene-4.in" not in text
    long = replace(SCENE, input=SCENE.input + "9 9\n" * 9)
    lessons = (replace(LESSONS[0], scene=long),)
    text = said(replace(judging, diagnosis=replace(DIAGNOSIS, lessons=lessons)), explain=True)
    assert "9 9\n9 9" not in text
    assert "     input /kept/scene-4.in\n" in text


def test_a_counterexample(case: Case, tmp_path: Path) -> None:
    kept = tmp_path / "kept.in"
    text = said(replace(failed(case), counterexample=replace(EXAMPLE, file=kept)))
    assert f"\n{EXAMPLE.input}  expected NO, found YES\n" in text
    assert EXAMPLE.sentence in text
    assert str(kept) in text
    assert "found in 1.2 s" in text or "found in 1.3 s" in text
    assert "seed 7 repeats this search" in text
    assert "  picture " not in text
    kept.with_suffix(".svg").touch()
    text = said(replace(failed(case), counterexample=replace(EXAMPLE, file=kept)))
    assert f"picture {kept.with_suffix('.svg')}" in text
    sequence = replace(EXAMPLE, scenarios=3)
    assert "the last of 3 scenarios" in said(replace(failed(case), counterexample=sequence))


def test_why_no_counterexample_was_found(case: Case) -> None:
    judging = replace(failed(case), unexplained="nothing smaller fails\x1b[2J")
    assert "nothing smaller fails\\x1b[2J\n" in said(judging)


def test_what_others_wrote_cannot_move_the_cursor(case: Case) -> None:
    example = replace(EXAMPLE, found="\x1b[2J", sentence="\x1b[2J", steps=("\x1b",))
    lesson = MissedLesson("\x1b", "\x1b[2J", ("\x1b",))
    diagnosis = Diagnosis((lesson,), Like("\x1b", "\x1b"), "\x1b", 1, 1)
    text = said(replace(failed(case), counterexample=example, diagnosis=diagnosis), explain=True)
    assert "\x1b" not in text


def test_the_end_of_standard_error_and_all_of_it_on_request(case: Case) -> None:
    lines = [f"  line {n}" for n in range(1, 11)]
    crash = failed(case, verdict=Verdict.RTE, mismatch=None, stderr="\n".join(lines))
    text = said(crash)
    assert "standard error (the end; --verbose shows more):\n      line 5\n" in text
    assert "line 10\n" in text
    assert "standard error:\n      line 1\n" in said(crash, verbose=True)
    wrong = failed(case, stderr="debug")
    assert "debug" not in said(wrong)
    assert "debug" in said(wrong, verbose=True)


def test_the_report_has_it_between_the_table_and_the_limits(case: Case) -> None:
    console = Console(width=80, markup=False, highlight=False)
    with console.capture() as captured:
        print_report(console, replace(failed(case), diagnosis=DIAGNOSIS))
    text = captured.get()
    parts = ("group ", "first failure: WA on one: scenario 1", "it misses", "limits: ", "WA  0 of")
    places = [text.index(part) for part in parts]
    assert places == sorted(places)


def test_the_command_that_draws_works_in_any_directory_and_shell(
    source: Source, checker: Callable[..., subprocess.CompletedProcess[str]], tmp_path: Path
) -> None:
    """Printed in one directory; run in another, without the environment of the first."""
    done = checker(source("yes.py", WRONG), "--case", "sample/03*")
    command = re.search(r"^  see it (.*)$", done.stdout, re.MULTILINE)
    assert command is not None, done.stdout
    assert str(DATA / "sample/03-touch.in") in command[1]
    elsewhere = tmp_path / "else where"
    elsewhere.mkdir()
    shell = ["/bin/sh", "-c", command[1]]
    environment = {"PATH": os.environ["PATH"]}
    drawn = subprocess.run(
        shell, cwd=elsewhere, env=environment, capture_output=True, text=True, check=False
    )
    assert drawn.returncode == 0, drawn.stderr
    assert (elsewhere / "scene.svg").read_text().rstrip().endswith("</svg>")


def test_a_search_is_offered_and_its_result_told(
    source: Source, data: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The command line with a search: what it finds stands in every report."""
    monkeypatch.setattr("judge.cli.signal.signal", lambda *_: None)
    seeds: list[int | None] = []

    def make_search(seed: int | None, _add: bool) -> Search:
        seeds.append(seed)
        return lambda _failure: EXAMPLE

    explainers = Explainers(make_search, lambda diagnosis: diagnosis, lambda _failure: ())
    report, page = data.parent / "report.json", data.parent / "report.html"
    command = [str(source("yes.py", WRONG)), "--data", str(data), "--no-wall"]
    assert main(command, explainers) == 1
    offered = capsys.readouterr().out
    assert "--explain looks for a smallest input" in offered
    assert EXAMPLE.sentence not in offered
    reports = ["--json", str(report), "--html", str(page)]
    assert main([*command, "--explain", "--seed", "7", *reports], explainers) == 1
    told = capsys.readouterr().out
    assert "--explain looks" not in told
    assert EXAMPLE.sentence in told
    assert EXAMPLE.sentence in report.read_text()
    assert EXAMPLE.sentence in page.read_text().replace("&#39;", "'")
    assert seeds == [7]
    right = [str(source("echo.py", "print(open(0).read())\n")), *command[1:]]
    assert main(right, explainers) == 0
    assert "--explain" not in capsys.readouterr().out
