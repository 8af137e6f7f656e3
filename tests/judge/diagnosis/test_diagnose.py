"""A diagnosis at the end of a judging: what is left, and what a failure of it costs."""

from dataclasses import replace
from pathlib import Path

import pytest

from judge.compare import Mismatch
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
from strength.gallery.pool import MOST_VERTICES

PROBLEM = load()
LIMITS = RunLimits(5.0, 512, 8)
PASSES = Diagnosis((), None, "It answers all. Look for overflow.", 135, 0)


def result(group, verdict):
    case = Case(f"secret/{group}/01", group, Path("01.in"), Path("01.ans"))
    return CaseResult(case, verdict, 0.1, 0.1, 9.0)


@pytest.mark.parametrize(
    ("results", "words"),
    [
        ([("small", Verdict.RTE), ("large", Verdict.RTE)], "crashes on larger files"),
        ([("small", Verdict.WA), ("large", Verdict.RTE)], "look for rare positions"),
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


def right_answers(gallery):
    """Return attempts of a program that answers the gallery correctly."""
    answers = gallery.expected + "".join(gallery.expected[i] for i in gallery.echoes)
    output = "\n".join("YES" if letter == "Y" else "NO" for letter in answers).encode()

    def attempts(contents, _limits):
        for _content in contents:
            facts = Facts(0, None, 0.1, 0.1, 9.0, len(output), None)
            yield Attempt(facts, output, Judgement(Verdict.AC))

    return attempts


def test_a_right_program_on_the_gallery_is_told_what_is_left():
    gallery = load_gallery()
    cases = [result("large", Verdict.WA)]
    found = diagnose(gallery, right_answers(gallery), LIMITS, PROBLEM, cases)
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
    start = MissedLesson("start-value", "Begin beyond all values.", ("start-value-1",))
    seen = after_example(gallery, replace(found, lessons=(start, exact)), example(23_435))
    assert [lesson.id for lesson in seen.lessons] == ["products", "start-value", "exact"]
    touch = Diagnosis((MissedLesson("touch", "Touch.", ()),), None, "", 135, 1)
    assert after_example(gallery, touch, example(23_435)) == touch


def test_a_small_counterexample_is_no_overflow():
    gallery = load_gallery()
    assert "it is no overflow" in after_example(gallery, PASSES, example(3)).remark
    fails = Diagnosis((), None, "It answers none.", 135, 135)
    assert after_example(gallery, fails, example(3)) == fails


def test_what_is_special_in_a_small_counterexample_is_said():
    facts = ("the move is vertical (dx = 0)", "the robot touches 2 obstacles")
    seen = after_example(load_gallery(), PASSES, replace(example(3), special=facts))
    assert seen.remark.endswith(f" In it, {facts[0]}; {facts[1]}.")
    assert seen.lessons == ()


def test_a_counterexample_with_more_vertices_than_all_scenes_points_at_limits():
    gallery = load_gallery()
    most = gallery.most_vertices
    assert most == MOST_VERTICES
    for vertices, said in ((most, False), (most + 1, True)):
        found = replace(example(3), vertices=vertices, special=("the move is vertical",))
        seen = after_example(gallery, PASSES, found)
        assert ("limit on steps" in seen.remark) == said
        assert ("the move is vertical" in seen.remark) != said


def test_tiny_polygons_that_need_large_numbers_are_rounding():
    gallery = load_gallery()
    seen = after_example(gallery, PASSES, example(50_000_000))
    assert [lesson.id for lesson in seen.lessons] == ["exact"]
    assert "50,000,000" in seen.remark
    large = replace(example(50_000_000), vertices=100_000)
    assert after_example(gallery, PASSES, large) == PASSES


def test_a_counterexample_with_too_many_words_says_that_each_scenario_gets_one_line():
    gallery = load_gallery()
    twice = replace(example(3), found="2 words for 1 scenario, at the end NO NO", in_step=False)
    seen = after_example(gallery, PASSES, twice)
    assert [lesson.id for lesson in seen.lessons] == ["one-line-each"]
    assert "overflow" not in seen.remark
    touch = Diagnosis((MissedLesson("touch", "Touch.", ()),), None, "", 135, 1)
    seen = after_example(gallery, touch, twice)
    assert [lesson.id for lesson in seen.lessons] == ["touch", "one-line-each"]
    assert after_example(gallery, seen, twice) == seen


@pytest.mark.parametrize(("expected", "found"), [(None, "NO"), ("YES", None)])
def test_a_case_with_too_much_or_too_little_output_says_so_too(expected, found):
    gallery = load_gallery()
    wrong = replace(result("large", Verdict.WA), mismatch=Mismatch(9, 9, 1, expected, found))
    diagnosis = diagnose(gallery, right_answers(gallery), LIMITS, PROBLEM, [wrong])
    assert [lesson.id for lesson in diagnosis.lessons] == ["one-line-each"]


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
