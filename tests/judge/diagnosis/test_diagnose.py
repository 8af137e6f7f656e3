"""A diagnosis at the end of a judging: what is left, and what a failure of it costs."""

from pathlib import Path

import pytest

from judge.decide import Judgement
from judge.diagnosis.diagnose import after_example, diagnose, what_is_left
from judge.diagnosis.gallery import GalleryError, load_gallery
from judge.explanation import Counterexample, Diagnosis, MissedLesson
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
        ([("small", Verdict.WA), ("large", Verdict.RTE)], "look for rounding or overflow"),
        ([("mine", Verdict.WA)], "gallery correctly."),
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
    judging = judge(read_submission(source), PROBLEM, Options(groups=("sample",), no_wall=True))
    assert judging.verdict is Verdict.WA
    assert judging.diagnosis is None
    assert judging.unexplained == str(error)


def test_a_judging_that_is_accepted_has_no_diagnosis():
    judging = judge(read_submission(REFERENCE), PROBLEM, Options(groups=("sample",)))
    assert judging.verdict is Verdict.AC
    assert judging.diagnosis is None


def example(largest):
    text = f"1\n3 1\n0 0\n0 0\n{largest} 0\n0 1\n3\n5 5\n6 5\n5 6\n"
    return Counterexample(text, "NO", "YES", 1, 1, 6, "Because.")


def test_a_counterexample_tells_32_bits_from_rounding():
    gallery = load_gallery()
    exact = MissedLesson("exact", "Exact.", ("exact-1",))
    found = Diagnosis((exact,), None, "", 135, 1)
    seen = after_example(gallery, found, example(23_435))
    assert [lesson.id for lesson in seen.lessons] == ["products", "exact"]
    assert "23,435" in seen.remark
    assert after_example(gallery, found, example(50_000_000)) == found
    touch = Diagnosis((MissedLesson("touch", "Touch.", ()),), None, "", 135, 1)
    assert after_example(gallery, touch, example(23_435)) == touch


def test_a_small_counterexample_is_no_overflow():
    gallery = load_gallery()
    passes = Diagnosis((), None, "It answers all. Look for overflow.", 135, 0)
    assert "it is no overflow" in after_example(gallery, passes, example(3)).remark
    fails = Diagnosis((), None, "It answers none.", 135, 135)
    assert after_example(gallery, fails, example(3)) == fails


def test_a_wrong_answer_file_of_a_user_is_said(tmp_path):
    source = tmp_path / "always.py"
    source.write_text("t = int(input())\nprint('YES\\n' * t)\n")
    data = tmp_path / "data"
    data.mkdir()
    (data / "a.in").write_text("1\n3 0\n0 0\n0 0\n1 0\n0 1\n")
    (data / "a.ans").write_text("NO\n")
    judging = judge(read_submission(source), PROBLEM, Options(data=data, no_wall=True))
    assert judging.verdict is Verdict.WA
    assert judging.diagnosis is None
    assert "scenario 1: the file says NO, the reference says YES" in judging.unexplained
