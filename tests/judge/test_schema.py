"""The JSON report: the committed schema is current, and reports follow it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import msgspec
import pytest

from judge.explanation import Counterexample, Diagnosis, Like, MissedLesson
from judge.kit.paths import ROOT
from judge.problem.cases import Case
from judge.problem.verdict import Verdict
from judge.reports.schema import Report, json_schema, report_of, to_json
from judge.results import CaseResult, GroupResult, Judging

CASE = Case("secret/small/01", "small", Path("01.in"), Path("01.ans"))
RESULT = CaseResult(CASE, Verdict.AC, 1.5, 2.0, 30.0, "", retried=True, first_verdict=Verdict.TLE)
JUDGING = Judging(
    submission="a.py",
    language="Python 3",
    verdict=Verdict.AC,
    score=15,
    max_score=100,
    partial=True,
    time_limit_s=5.0,
    declared_s=5.0,
    memory_mib=512,
    scale=None,
    groups=(GroupResult("small", Verdict.AC, 15, 15, True, (RESULT,)),),
)


def test_the_committed_schema_is_current() -> None:
    committed = (ROOT / "docs/report.schema.json").read_bytes()
    assert committed == json_schema(), "run `make schema`"


def test_a_report_follows_the_schema() -> None:
    assert msgspec.json.decode(to_json(JUDGING), type=Report) == report_of(JUDGING)


def test_a_report_of_a_program_that_is_explained() -> None:
    """And what is in it, word by word: other tools show it."""
    diagnosis = Diagnosis(
        (MissedLesson("touch", "Touching is a collision.", ("corner", "edge")),),
        Like("wrong_answer/strict_touch.py", "takes touching for free"),
        "a remark",
        scenes=96,
        wrong=12,
    )
    example = Counterexample(
        *("1\n", "NO", "YES", 1, 2, 7, "because"), "<svg/>", Path("x.in"), 1.25, ("seed 7",)
    )
    explained = replace(JUDGING, diagnosis=diagnosis, counterexample=example)
    text = to_json(explained)
    assert msgspec.json.decode(text, type=Report) == report_of(explained)
    found = msgspec.json.decode(text)
    assert found["diagnosis"] == {
        "lessons": [
            {
                "id": "touch",
                "sentence": "Touching is a collision.",
                "scenarios": ["corner", "edge"],
            }
        ],
        "remark": "a remark",
        "scenarios": 96,
        "wrong": 12,
    }
    assert found["like"] == {
        "submission": "wrong_answer/strict_touch.py",
        "bug": "takes touching for free",
    }
    assert found["counterexample"] == {
        **{"input": "1\n", "expected": "NO", "found": "YES", "sentence": "because"},
        **{"scenarios": 1, "obstacles": 2, "vertices": 7},
        **{"file": "x.in", "seconds": 1.25, "steps": ["seed 7"]},
    }
    for kind, part in [
        ("DiagnosisReport", found["diagnosis"]),
        ("LessonReport", found["diagnosis"]["lessons"][0]),
        ("LikeReport", found["like"]),
        ("CounterexampleReport", found["counterexample"]),
    ]:
        assert set(msgspec.json.decode(json_schema())["$defs"][kind]["required"]) == set(part)


def test_the_schema_names_every_field_and_no_other() -> None:
    definitions = msgspec.json.decode(json_schema())["$defs"]
    report = msgspec.json.decode(to_json(JUDGING))
    for name, found in [
        ("Report", report),
        ("GroupReport", report["groups"][0]),
        ("CaseReport", report["cases"][0]),
    ]:
        assert set(definitions[name]["required"]) == set(found)
        assert definitions[name]["additionalProperties"] is False
    assert set(definitions["Verdict"]["enum"]) == set(Verdict)


@pytest.mark.parametrize(
    ("old", "new"), [('"AC"', '"OK"'), ('"score": 15', '"score": -1'), ('"scale"', '"scales"')]
)
def test_a_wrong_report_is_rejected(old: str, new: str) -> None:
    with pytest.raises(msgspec.ValidationError):
        msgspec.json.decode(to_json(JUDGING).decode().replace(old, new, 1), type=Report)
