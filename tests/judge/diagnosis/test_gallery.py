"""The gallery that is shipped: valid, small, reproducible, current, and telling."""

import io

import pytest

from gen.scenario import parse
from gen.validator import load_rules, validate
from judge.diagnosis.diagnose import read
from judge.diagnosis.gallery import (
    GALLERY,
    NO,
    YES,
    Gallery,
    GalleryError,
    Lesson,
    Scene,
    input_file,
    load_gallery,
)
from judge.diagnosis.ranking import known_alike, missed_lessons, wrong_scenes
from judge.explanation import FailedScene
from judge.kit.paths import BRUTE_FORCE, REFERENCE
from judge.kit.trusted import python_command, read_answers, run_trusted
from judge.problem.declaration import load
from judge.sandbox.sandbox import Sandbox
from strength.gallery.choose import TWO_HIT
from strength.gallery.conditions import conditions_of, obstacles_met
from strength.gallery.measure import faults, measure, steady_answers
from strength.gallery.pool import MOST_OBSTACLES, MOST_VERTICES, remade
from strength.gallery.programs import each, faulty_submissions
from strength.gallery.write import answers_text, scenes_text

SHIPPED = load_gallery()
PROBLEM = load()
SOME = (
    "wrong_answer/strict_touch.py",
    "wrong_answer/answer_kept.py",
    "wrong_answer/no_for_each_hit.py",
    "run_time_error/exit_code_3.py",
)
OUT_OF_STEP = {
    "wrong_answer/no_for_each_hit.py": "one-line-each",
    "run_time_error/exit_code_3.py": "exit-status",
}
# What no tiny scenario can catch: they fail with large polygons only.
LARGE_ONLY = {
    "run_time_error/array_too_small.cpp",
    "run_time_error/deep_recursion.py",
    "wrong_answer/bisection_of_16_steps.cpp",
    "wrong_answer/edges_of_large_robots_skipped.cpp",
    "wrong_answer/robot_cut_to_100000.cpp",
}


def asked(names):
    answers = {}
    with Sandbox(keepers=2) as sandbox:

        def ask(faulty):
            answers[faulty.name] = faulty.asked(SHIPPED)

        each(names, PROBLEM, sandbox, 2, ask)
    return {name: answers[name] for name in names}


def test_every_scene_is_valid_and_tiny():
    validate(io.BytesIO(input_file(SHIPPED.scenes)), load_rules())
    assert 50 <= len(SHIPPED.scenes) <= 150
    for scene, scenario in zip(SHIPPED.scenes, parse(input_file(SHIPPED.scenes)), strict=True):
        assert len(scenario.obstacles) <= MOST_OBSTACLES, scene.name
        assert scenario.vertices <= MOST_VERTICES, scene.name
        assert scene.obstacles == len(scenario.obstacles)
        assert scene.vertices == scenario.vertices
        assert scene.matters == conditions_of(scenario) & SHIPPED.lessons.keys(), scene.name


def test_some_scenes_have_two_obstacles_that_are_both_touched():
    scenarios = parse(input_file(SHIPPED.scenes))
    assert sum(obstacles_met(scenario) > 1 for scenario in scenarios) >= TWO_HIT


@pytest.mark.parametrize("solver", [REFERENCE, BRUTE_FORCE], ids=lambda path: path.name)
def test_every_answer_is_right(solver):
    output = run_trusted(solver.name, python_command(solver), input_file(SHIPPED.scenes))
    found = read_answers(solver.name, output, len(SHIPPED.scenes))
    assert found == [scene.answer for scene in SHIPPED.scenes]
    assert {YES, NO} == set(found)


@pytest.mark.parametrize("many", [4, pytest.param(8, marks=pytest.mark.slow)])
def test_scenes_are_reproduced_from_how_they_were_made(many):
    made = [scene for scene in SHIPPED.scenes if scene.made]
    assert made
    for scene in made[:: len(made) // many]:
        assert [remade(scene.made)] == parse(input_file([scene])), scene.name


def test_the_file_of_scenes_is_as_the_command_writes_it():
    assert (GALLERY / "scenes.toml").read_text() == scenes_text(SHIPPED.scenes)


def test_every_wrong_submission_misses_a_lesson_or_fails_with_large_polygons_only():
    labelled = {name for lesson in SHIPPED.lessons.values() for name in lesson.missed_by}
    assert labelled | LARGE_ONLY == set(faulty_submissions(PROBLEM))
    assert not labelled & LARGE_ONLY
    right = {name for name, given in SHIPPED.known.items() if given == SHIPPED.expected}
    assert right <= LARGE_ONLY


def test_known_answers_are_current():
    answers = asked(SOME)
    steady = steady_answers(answers)
    assert steady == {n: SHIPPED.known[n] for n in SOME if n in SHIPPED.known}
    assert set(steady) == {"wrong_answer/strict_touch.py"}
    for name, lesson in OUT_OF_STEP.items():
        assert [one.id for one in read(SHIPPED, answers[name]).lessons] == [lesson]


@pytest.mark.slow
@pytest.mark.usefixtures("compiled_once")
def test_all_known_answers_are_current_and_the_first_lesson_is_nearly_always_the_true_one():
    answers = asked(faulty_submissions(PROBLEM))
    assert answers_text(steady_answers(answers)) == (GALLERY / "answers.json").read_bytes()
    measured = [one for one in measure(SHIPPED, answers) if one.true]
    assert faults(measured, SHIPPED) == []
    assert sum(one.first_is_true for one in measured) >= 0.9 * len(measured)
    assert sum(bool(one.true & set(one.named[:3])) for one in measured) >= 0.95 * len(measured)


def test_every_known_program_misses_its_own_lesson():
    for name, given in SHIPPED.known.items():
        wrong = wrong_scenes(SHIPPED, given)
        if wrong and SHIPPED.lessons_of(name) <= SHIPPED.taught:
            told = {lesson.id for lesson in missed_lessons(SHIPPED, given)}
            assert told & SHIPPED.lessons_of(name), name
            assert len(wrong) >= 2, name


def test_a_program_that_answers_like_a_known_one_is_told_its_bug():
    given = SHIPPED.known["wrong_answer/strict_touch.py"]
    like = known_alike(SHIPPED, given)
    assert like is not None
    assert like.bug == "takes touching for free"
    assert known_alike(SHIPPED, SHIPPED.expected) is None
    index = min(set(range(len(given))) - wrong_scenes(SHIPPED, given))
    other = "N" if given[index] == "Y" else "Y"
    assert known_alike(SHIPPED, given[:index] + other + given[index + 1 :]) is None


def test_a_missed_lesson_shows_the_smallest_of_its_own_scenes():
    scenes = (
        Scene("large", "touch", NO, "3 1\n0 0\n0 0\n"),
        Scene("other", "inside", NO, "3\n"),
        Scene("small", "touch", NO, "3 1\n0 0\n"),
        Scene("right", "touch", YES, "3\n"),
    )
    gallery = Gallery({"touch": Lesson("T."), "inside": Lesson("I.")}, scenes, {})
    told = {lesson.id: lesson.scene for lesson in missed_lessons(gallery, "YY-Y")}
    assert told["touch"] == FailedScene("small", "1\n3 1\n0 0\n", NO, "no answer")
    assert told["inside"] == FailedScene("other", "1\n3\n", NO, YES)
    told = {lesson.id: lesson.scene for lesson in missed_lessons(gallery, "YYNN")}
    assert told["touch"] == FailedScene("right", "1\n3\n", YES, NO)


def test_a_lesson_whose_condition_all_wrong_scenes_meet_comes_before_one_where_some_do_not():
    lessons = {"inside": Lesson("Inside."), "standing-still": Lesson("Still.")}
    still = frozenset({"standing-still"})
    scenes = (
        Scene("a", "inside", NO, "3 1\n0 0\n", still),
        Scene("b", "inside", NO, "3 1\n0 0\n", still),
        Scene("c", "standing-still", NO, "3 1\n0 0\n", still),
        Scene("d", "inside", NO, "3 1\n1 0\n"),
    )
    gallery = Gallery(lessons, scenes, {})
    (only,) = missed_lessons(gallery, "YYYN")
    assert (only.id, only.scenes) == ("standing-still", ("c", "a", "b"))
    assert [one.id for one in missed_lessons(gallery, "NYNY")] == ["inside"]


@pytest.mark.parametrize(
    ("text", "lessons"),
    [
        ("3 0 0 0 0 0 1 0 0 1", {"no-obstacles", "standing-still", "lowest-tie", "same-x"}),
        # the robot's right corner runs against the middle of an upright edge, at the very end
        (
            "3 1 2 0 0 0 2 1 0 2 3 4 -1 6 0 4 3",
            {
                *("touch", "touch-at-end", "touch-corners", "bounding-shapes"),
                *("lowest-tie", "same-x", "ray-through-vertex"),
            },
        ),
        # a small robot inside a large triangle
        (
            "3 1 0 0 1 1 2 1 1 2 3 0 0 9 0 0 9",
            {"standing-still", "overlap-at-start", "robot-inside", "lowest-tie", "same-x"},
        ),
        # straight down, far from a triangle without vertical or level edges
        (
            "3 1 0 5 0 0 1 0 0 1 3 9 9 11 10 10 12",
            {"vertical-move", "edge-along-move", "axes-of-both", "lowest-tie", "same-x"},
        ),
    ],
)
def test_conditions_of_scenes_that_were_thought_through(text, lessons):
    (scenario,) = parse(f"1 {text}".encode())
    assert conditions_of(scenario) == lessons


@pytest.mark.parametrize(
    ("file", "text", "message"),
    [
        ("lessons.toml", "[touch]\nsentense = 'x'", "unknown field `sentense`"),
        ("scenes.toml", "[[scenes]]\nname='a'\nlesson='b'\nanswer='NO'\ninput=''", "no lesson 'b'"),
        ("scenes.toml", "[[scenes]]\nname='a'\nlesson='t'\nanswer='no'\ninput=''", "found 'no'"),
        ("scenes.toml", "[[scenes]", "scenes.toml"),
        ("answers.json", '{"x": "YN"}', "expected 0 answers, found 2"),
        ("answers.json", "{", "answers.json"),
    ],
)
def test_a_damaged_gallery_is_one_line(tmp_path, file, text, message):
    (tmp_path / "lessons.toml").write_text("[t]\nsentence = 'T.'\n")
    (tmp_path / "scenes.toml").write_text("scenes = []\n")
    (tmp_path / "answers.json").write_text("{}")
    load_gallery(tmp_path)
    (tmp_path / file).write_text(text)
    with pytest.raises(GalleryError, match=r"(?s).*") as found:
        load_gallery(tmp_path)
    assert message in str(found.value)


def test_a_missing_gallery_is_one_line(tmp_path):
    with pytest.raises(GalleryError, match=r"lessons\.toml: cannot be read: No such file"):
        load_gallery(tmp_path)
