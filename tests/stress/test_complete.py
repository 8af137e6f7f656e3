"""Programs in C++ and Python on complete worlds."""

import pytest

from judge.kit.paths import SUBMISSIONS
from judge.languages.table import LanguageError
from judge.sandbox.sandbox import Sandbox
from stress.cli import COMPLETE
from stress.compare import compare
from stress.programs import CPP, PYTHON, ready
from stress.worlds import box_world

SMALLEST = box_world(*COMPLETE[0])


@pytest.fixture(scope="module")
def programs():
    with Sandbox() as sandbox:
        try:
            yield ready(CPP, sandbox)
        except LanguageError as error:
            pytest.skip(str(error))


def test_all_programs_agree_on_a_complete_world(programs):
    with Sandbox() as sandbox:
        python = ready(PYTHON, sandbox, every=2)
        outcome = compare(SMALLEST.files(5_000), [*programs, *python], jobs=2)
    assert outcome.disagreement is None
    assert outcome.scenarios == 22_090
    assert outcome.answered == (22_090,) * 3 + (12_090,) * 3  # parts 0, 2 and the short one, 4


@pytest.mark.parametrize(
    "shape",
    [COMPLETE[1], *(pytest.param(shape, marks=pytest.mark.slow) for shape in COMPLETE[2:])],
    ids=str,
)
def test_all_programs_agree_on_a_sample_of_the_larger_worlds(programs, shape):
    world = box_world(*shape)
    with Sandbox() as sandbox:
        every = [*programs, *ready(PYTHON, sandbox)]
        files = world.files(2_500, every=world.size // 2_500 // 4)
        outcome = compare(files, every, jobs=2)
    assert outcome.disagreement is None
    assert outcome.scenarios >= 10_000
    assert outcome.answered == (outcome.scenarios,) * 6
    assert outcome.yes > 500


@pytest.mark.slow  # fast tests of `compare` find differences, too
def test_a_difference_is_found(programs):
    with Sandbox() as sandbox:
        wrong = ready([SUBMISSIONS / "wrong_answer" / "axes_touch_free.cpp"], sandbox)
        outcome = compare(SMALLEST.files(31_250), [programs[0], *wrong], jobs=1)
    assert outcome.disagreement is not None
    assert outcome.disagreement.answers == (("textbook.cpp", "NO"), ("axes_touch_free.cpp", "YES"))
