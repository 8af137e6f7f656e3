"""results.json has the documented form, tells no more than permitted, and blames nobody wrongly."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any
from xml.etree import ElementTree as ET

import pytest

from autograder.inline import SVG, without_stylesheet
from autograder.results import broken, judged, refused
from export.verify.gradescope import read_results
from gen.scenario import parse
from judge.compare import Mismatch
from judge.explanation import (
    Counterexample,
    Diagnosis,
    FailedScene,
    Like,
    MissedLesson,
    Size,
    Slowness,
)
from judge.feedback import told
from judge.kit.paths import DATA
from judge.problem.cases import Case, case_at
from judge.problem.declaration import Feedback, load
from judge.problem.verdict import Verdict
from judge.results import CaseResult, GroupResult, Judging
from pictures.explain import explain_picture

SCENE = "1\n3 1\n0 0\n0 0\n1 0\n0 1\n3\n1 0\n2 0\n2 1\n"
EXAMPLE = Counterexample(
    input=SCENE,
    expected="NO",
    found="YES <b>",
    scenarios=1,
    obstacles=1,
    vertices=6,
    sentence="the corners are the same.",
    picture=explain_picture(parse(SCENE.encode())[0], answer="NO", found="YES <b>"),
)
DIAGNOSIS = Diagnosis(
    (MissedLesson("touch", "A touch counts.", ("scene-1",)),),
    Like("wrong_answer/strict_touch.py", "takes touching for free"),
    "A remark.",
    scenes=96,
    wrong=12,
)
MISMATCH = Mismatch(77, 88, 99, "NO", "maybe")
OPEN = Feedback(tell="counterexample", name_secret_cases=True)


def ran(name: str, verdict: Verdict, message: str = "") -> CaseResult:
    mismatch = MISMATCH if verdict is Verdict.WA else None
    stderr = "its words" if verdict is Verdict.RTE else ""
    case: Case = case_at(DATA, name)
    return CaseResult(case, verdict, 0.5, 0.6, 9.0, message, mismatch=mismatch, stderr=stderr)


SAMPLE = ran("sample/01-first", Verdict.AC)
ALPHA, BETA = ran("secret/small/alpha", Verdict.AC), ran("secret/small/beta", Verdict.WA, "differs")
GAMMA = ran("secret/many/gamma", Verdict.RTE, "exit status 1: its words")
JUDGING = Judging(
    *("a <b>.py", "Python 3", Verdict.WA, 0, 100, False, 5.0, 5.0, 512, None),
    (
        GroupResult("sample", Verdict.AC, 0, 0, True, (SAMPLE,)),
        GroupResult("small", Verdict.WA, 0, 15, True, (ALPHA, BETA)),
        GroupResult("many", Verdict.RTE, 0, 20, True, (GAMMA,)),
    ),
    diagnosis=DIAGNOSIS,
    counterexample=EXAMPLE,
)


def test_it_tells_why() -> None:
    results = read_results(judged(JUDGING, 12.34))
    assert (results["score"], results["execution_time"]) == (0, 12.3)
    for said in ("WA", "A touch counts.", "takes touching for free", "A remark.", SCENE, "<svg"):
        assert said in results["output"]
    assert "the corners are the same." in results["output"]
    assert [(test["name"], test["status"]) for test in results["tests"]] == [
        ("sample", "passed"),
        ("small", "failed"),
        ("many", "failed"),
    ]
    assert [(test["score"], test["max_score"]) for test in results["tests"]] == [
        (0, 0),
        (0, 15),
        (0, 20),
    ]
    assert "first failure: secret/small/beta: differs" in results["tests"][1]["output"]
    assert "its words" in results["tests"][2]["output"]


def test_without_a_counterexample_the_scene_of_the_first_lesson_is_shown() -> None:
    scene = FailedScene("touch-1", SCENE, "NO", "YES", "They touch.", EXAMPLE.picture)
    lessons = tuple(MissedLesson(n, f"Sentence {n}.", ("touch-1",), scene) for n in ("a", "b"))
    judging = replace(JUDGING, diagnosis=replace(DIAGNOSIS, lessons=lessons))
    assert "They touch." not in read_results(judged(judging, 1.0))["output"]
    output = read_results(judged(replace(judging, counterexample=None), 1.0))["output"]
    assert output.count("They touch.") == output.count(f"<pre>{SCENE}</pre>") == 1
    assert output.count("<svg") == 1


def test_a_slow_program_is_told_why() -> None:
    size = Size("secret/large/01", "", "", 1, 1000, 1000, 9, 1_000_000, 9_000_000)
    output = read_results(judged(replace(JUDGING, slowness=Slowness(size)), 1.0))["output"]
    assert "Why it is too slow" in output
    assert "secret/large/01" in output


def test_what_a_student_writes_is_no_markup() -> None:
    output = read_results(judged(JUDGING, 1.0))["output"]
    assert "a &lt;b&gt;.py" in output
    assert "YES <b>" not in output


def test_all_points_are_seen() -> None:
    """With a hidden test, Gradescope would hide the score from students."""
    tests = read_results(judged(JUDGING, 1.0))["tests"]
    assert {test["visibility"] for test in tests} == {"visible"}


@pytest.mark.parametrize("tell", ["verdict", "lessons", "counterexample"])
def test_it_obeys_the_setter(tell: Any) -> None:
    permitted = told(JUDGING, Feedback(tell=tell, name_secret_cases=False))
    results = read_results(judged(permitted, 1.0))
    everything = json.dumps(results)
    for secret in ("alpha", "beta", "gamma", "differs", "its words"):
        assert secret not in everything
    assert "secret/small/#2" in results["tests"][1]["output"]
    assert ("A touch counts." in everything) is (tell != "verdict")
    assert ("<svg" in everything) is (tell == "counterexample")


def test_a_program_that_does_not_compile() -> None:
    groups = tuple(replace(group, verdict=Verdict.CE) for group in JUDGING.groups)
    judging = replace(
        JUDGING,
        verdict=Verdict.CE,
        message="a.cpp:1: <oops>",
        groups=groups,
        diagnosis=None,
        counterexample=None,
    )
    results = read_results(judged(judging, 1.0))
    assert "a.cpp:1: &lt;oops&gt;" in results["output"]
    assert {test["status"] for test in results["tests"]} == {"failed"}


def test_nothing_to_judge_scores_nothing() -> None:
    results = read_results(refused("expected one source file, found none", load().groups))
    assert results["score"] == 0
    assert sum(test["max_score"] for test in results["tests"]) == 100
    assert "found none" in results["output"]


def test_a_failure_of_the_judge_gives_no_score() -> None:
    results = read_results(broken("no space left"))
    assert "score" not in results
    assert all("score" not in test for test in results["tests"])
    assert "not your program's fault" in results["output"]
    assert "no space left" not in results["output"]
    assert [test["visibility"] for test in results["tests"]] == ["hidden"]


def test_the_picture_needs_no_style_sheet() -> None:
    picture = without_stylesheet(EXAMPLE.picture)
    root = ET.fromstring(picture)
    assert root.tag == f"{{{SVG}}}svg"
    assert not [
        each for each in root.iter() if "class" in each.attrib or each.tag.endswith("style")
    ]
    shapes = [each for each in root.iter() if each.tag.endswith(("path", "rect", "circle", "text"))]
    clips = {child for clip in root.iter(f"{{{SVG}}}clipPath") for child in clip}
    bare = [
        each for each in shapes if each not in clips and {"fill", "stroke"}.isdisjoint(each.keys())
    ]
    assert len(shapes) > 20
    assert bare == []
