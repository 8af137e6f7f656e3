"""The choice of the gallery's scenes: symmetries, mutants, variety, small numbers first."""

import io

import pytest

from gen.scenario import Scenario, parse, render
from gen.validator import load_rules, validate
from judge.diagnosis.gallery import Lesson, input_file, load_gallery
from judge.kit.paths import REFERENCE
from judge.kit.trusted import python_command, run_trusted
from strength.gallery.choose import choose, mutants_of, shortlist
from strength.gallery.pool import TURNS, Candidate, disguised, turned

SHIPPED = load_gallery()
ROBOT = [(0, 0), (3, 1), (1, 4)]
FAR = [(20, 21), (27, 23), (22, 29)]


def scene(x, scale=1):
    robot, obstacle = ([(scale * a, scale * b) for a, b in polygon] for polygon in (ROBOT, FAR))
    return Candidate(Scenario(robot, (scale * x, scale * (2 * x + 1)), [obstacle]), {})


def chosen(pool, answers, mutants, lessons):
    right = "Y" * len(pool)
    short = shortlist(pool, right, answers, lessons)
    scenes = choose(pool, right, short, mutants, lessons)
    inputs = {render([c.scenario]).decode().partition("\n")[2]: i for i, c in enumerate(pool)}
    return {(scene.lesson, inputs[scene.input]) for scene in scenes}


@pytest.mark.parametrize("turn", range(TURNS))
def test_a_scene_in_disguise_is_valid_and_has_the_same_answer(turn):
    some = parse(input_file(SHIPPED.scenes))[::5]
    for change in (turned, disguised):
        content = render([change(scenario, turn) for scenario in some])
        validate(io.BytesIO(content), load_rules())
        output = run_trusted(REFERENCE.name, python_command(REFERENCE), content)
        assert "".join(word[0] for word in output.decode().split()) == SHIPPED.expected[::5]


def test_the_eight_turns_are_different_and_the_first_changes_nothing():
    scenario = Scenario(ROBOT, (1, 2), [FAR])
    assert len({render([turned(scenario, turn)]) for turn in range(TURNS)}) == TURNS
    assert turned(scenario, 0) == disguised(scenario, 0) == scenario


def test_each_lesson_gets_scenes_that_its_own_programs_fail():
    pool = [scene(x) for x in range(1, 30)]
    answers = {"a": "NNN" + "Y" * 26, "b": "YNN" + "N" * 4 + "Y" * 22}
    lessons = {"one": Lesson("One.", {"a": "..."}), "two": Lesson("Two.", {"b": "..."})}
    found = chosen(pool, answers, {}, lessons)
    assert ("one", 0) in found
    assert {index for lesson, index in found if lesson == "two"} <= {1, 2, 3, 4, 5, 6}


def test_a_scene_that_a_mutant_fails_is_taken_before_those_that_it_passes():
    pool = [scene(x) for x in range(1, 30)]
    lessons = {"one": Lesson("One.", {"a": "..."})}
    answers = {"a": "N" * 10 + "Y" * 19}
    mutants = {"a": [frozenset(range(10)), frozenset({7}), frozenset({9})]}
    assert {("one", 7), ("one", 9)} <= chosen(pool, answers, mutants, lessons)


def test_large_numbers_are_the_last_resort_but_for_lessons_about_numbers():
    pool = [scene(3, 10**6), *(scene(x) for x in range(3, 30)), scene(7, 10**6)]
    fails = {"a": "NN" + "Y" * 26 + "N"} | dict.fromkeys("bcdefg", "YN" + "Y" * 27)
    lesson = Lesson("One.", {"a": "..."})
    short = shortlist(pool, "Y" * len(pool), fails, {"swept-area": lesson, "exact": lesson})
    assert short["swept-area"]["a"] == [1, 0, 28]
    assert short["exact"]["a"] == [0, 28, 1]


def test_mutants_are_read_from_the_answers_to_each_disguise_in_turn():
    right = "YNYN"
    found = mutants_of({"a": "YNY" + "NNN"}, [0, 1, 3], right)
    assert found == {"a": [frozenset({3}), frozenset({0})]}
