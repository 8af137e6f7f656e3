"""A diagnosis at the end of a judging: what is left, and what a failure of it costs."""

from pathlib import Path

import pytest

from judge.decide import Judgement
from judge.diagnosis.diagnose import diagnose, what_is_left
from judge.diagnosis.gallery import GalleryError, load_gallery
from judge.judging import Options, judge
from judge.kit.paths import REFERENCE
from judge.languages.submission import read_submission
from judge.problem.cases import Case
from judge.problem.declaration import load
from judge.problem.verdict import Verdict
from judge.results import CaseResult
from judge.run import Attempt
from judge.sandbox.facts import Facts, RunLimits
from judge.sandbox.sandbox import SandboxError

PROBLEM = load()
LIMITS = RunLimits(5.0, 512, 8)


def result(group, verdict):
    case = Case(f"secret/{group}/01", group, Path("01.in"), Path("01.ans"))
    return CaseResult(case, verdict, 0.1, 0.1, 9.0)


@pytest.mark.parametrize(
    ("results", "words"),
    [
        ([("small", Verdict.RTE), ("large", Verdict.RTE)], "crashes on larger files"),
        ([("small", Verdict.WA), ("large", Verdict.RTE)], "what is left is precision"),
        ([("small", Verdict.AC), ("large", Verdict.WA)], "fails on large files only"),
    ],
)
def test_a_program_that_knows_the_gallery_is_told_what_is_left(results, words):
    assert words in what_is_left(PROBLEM, [result(*each) for each in results])


def test_only_wrong_answers_and_crashes_are_diagnosed():
    def attempts(_contents, _limits):
        raise AssertionError("it was run")

    cases = [result("small", Verdict.TLE), result("large", Verdict.MLE)]
    assert diagnose(load_gallery(), attempts, LIMITS, PROBLEM, cases) is None


def test_a_right_program_on_the_gallery_is_told_what_is_left():
    gallery = load_gallery()
    answers = gallery.expected + "".join(gallery.expected[i] for i in gallery.echoes)
    output = "\n".join("YES" if letter == "Y" else "NO" for letter in answers).encode()

    def attempts(contents, _limits):
        for _content in contents:
            facts = Facts(0, None, 0.1, 0.1, 9.0, len(output), None)
            yield Attempt(facts, output, Judgement(Verdict.AC))

    found = diagnose(gallery, attempts, LIMITS, PROBLEM, [result("large", Verdict.WA)])
    assert found.lessons == ()
    assert "fails on large files only" in found.remark


@pytest.mark.parametrize("error", [GalleryError("g.toml: damaged"), SandboxError("no space")])
def test_a_failure_of_the_diagnosis_costs_only_the_diagnosis(monkeypatch, tmp_path, error):
    def fails(*_arguments):
        raise error

    monkeypatch.setattr("judge.judging.diagnose", fails)
    source = tmp_path / "always.py"
    source.write_text("t = int(input())\nprint('YES\\n' * t)\n")
    judging = judge(read_submission(source), PROBLEM, Options(globs=("sample/*",), no_wall=True))
    assert judging.verdict is Verdict.WA
    assert judging.diagnosis is None
    assert judging.unexplained == str(error)


def test_a_judging_that_is_accepted_has_no_diagnosis():
    judging = judge(read_submission(REFERENCE), PROBLEM, Options(globs=("sample/*",)))
    assert judging.verdict is Verdict.AC
    assert judging.diagnosis is None
