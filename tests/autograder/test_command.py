"""The autograder's command: results.json is there, whole, whatever happens."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from autograder import cli
from judge.judging import JudgeError, Options
from judge.problem.verdict import Verdict
from judge.results import Judging

from .test_results import JUDGING, ran

ALWAYS_YES = "for _ in range(int(input())):\n    print('YES')\n"


def graded(place: Path, source: str | None) -> tuple[int, dict[str, Any]]:
    (place / "submission").mkdir()
    if source is not None:
        (place / "submission" / "a.py").write_text(source)
    status = cli.main([str(place)])
    return status, json.loads((place / "results" / "results.json").read_bytes())


@pytest.fixture
def only_samples(monkeypatch: pytest.MonkeyPatch) -> None:
    def judge(submission: Any, problem: Any, options: Options, **more: Any) -> Judging:
        assert options.no_wall
        assert more["search"] is not None
        chosen = Options(groups=("sample",), no_wall=True)
        return real(submission, problem, chosen)

    real = cli.judge
    monkeypatch.setattr(cli, "judge", judge)


@pytest.mark.usefixtures("only_samples")
def test_a_program_is_judged(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, results = graded(tmp_path, ALWAYS_YES)
    assert status == 0
    assert results["tests"][0]["name"] == "sample"
    assert results["tests"][0]["status"] == "failed"
    assert "a.py" in capsys.readouterr().out


def test_a_strange_name_is_no_fault_of_the_judge(tmp_path: Path) -> None:
    (tmp_path / "submission").mkdir()
    (tmp_path / "submission" / "\udcff \x1b[2J.txt").write_text("My answer.")
    assert cli.main([str(tmp_path)]) == 0
    results = json.loads((tmp_path / "results" / "results.json").read_bytes())
    assert r"\udcff \x1b[2J.txt: expected a suffix" in results["output"]


def test_no_program_scores_nothing(tmp_path: Path) -> None:
    status, results = graded(tmp_path, None)
    assert (status, results["score"]) == (0, 0)


@pytest.mark.parametrize(
    "error", [JudgeError("no space"), ZeroDivisionError(), OSError(28, "full")]
)
def test_a_fault_of_the_judge_gives_no_score(
    error: Exception, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def judge(*_: object, **__: object) -> Judging:
        raise error

    monkeypatch.setattr(cli, "judge", judge)
    status, results = graded(tmp_path, ALWAYS_YES)
    assert status == 2
    assert "score" not in results


def test_one_run_that_the_machine_spoiled_gives_no_score(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Even if an earlier failure decides the verdict."""
    spoiled = ran("secret/many/gamma", Verdict.JE, "the disk is full")
    groups = (*JUDGING.groups[:2], replace(JUDGING.groups[2], cases=(spoiled,)))
    monkeypatch.setattr(cli, "judge", lambda *_, **__: replace(JUDGING, groups=groups))
    status, results = graded(tmp_path, ALWAYS_YES)
    assert status == 2
    assert "score" not in results
    assert "the disk is full" in results["tests"][0]["output"]
