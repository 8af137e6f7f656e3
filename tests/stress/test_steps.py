"""What every step of shrinking makes: valid scenarios with a smaller measure."""

import io

import pytest

from gen.rng import Rng
from gen.scenario import Scenario, moved, render
from gen.validator import load_rules, validate
from judge.kit.paths import REFERENCE
from judge.kit.trusted import python_command, read_answers, run_trusted
from stress.chance import random_scenarios
from stress.running.reference import answers
from stress.search.draw import of_families
from stress.shrinking import steps
from stress.shrinking.measure import is_valid, measure, numbers_of
from stress.shrinking.steps.parts import parts

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
TRIANGLE = [(0, 0), (1, 0), (0, 1)]
TINY = list(random_scenarios(7, 12))
HUGE = [moved(scenario, (99_999_900, -99_999_950)) for scenario in TINY[:3]]


def families():
    source = of_families(Rng(5))
    return [next(source) for _ in range(120)][::12]


@pytest.mark.parametrize("scenario", [*TINY[:4], *HUGE[:1], *families()[:4]])
def test_all_candidates_are_valid_and_smaller_and_different(scenario):
    rules, size = load_rules(), measure(scenario)
    seen = set()
    for batch in steps.smaller(scenario, Rng(1)):
        validate(io.BytesIO(render(batch)), rules)
        sizes = [(measure(candidate), numbers_of(candidate)) for candidate in batch]
        assert sizes == sorted(sizes)
        assert sizes[-1][0] < size
        assert seen.isdisjoint(sizes)
        seen.update(sizes)


@pytest.mark.parametrize("step", steps.COARSE + steps.FINE, ids=lambda step: step.__name__)
def test_every_kind_of_step_makes_something(step):
    rng = Rng(1)
    made = 0
    for scenario in [*TINY, *HUGE]:
        size = measure(scenario)
        made += sum(
            measure(candidate) < size and is_valid(candidate) for candidate in step(scenario, rng)
        )
    assert made > 10


def test_the_measure_counts_obstacles_then_vertices_then_numbers():
    ordered = [
        Scenario(TRIANGLE, (0, 0), []),
        Scenario(TRIANGLE, (0, 1), []),
        Scenario(TRIANGLE, (0, -1), []),
        Scenario(TRIANGLE, (0, 9), []),
        Scenario(SQUARE, (0, 0), []),
        Scenario(SQUARE, (0, 0), [TRIANGLE]),
        Scenario(SQUARE, (0, 0), [SQUARE]),
        Scenario(TRIANGLE, (0, 0), [TRIANGLE, TRIANGLE]),
    ]
    assert sorted(ordered, key=measure) == ordered
    turned = TRIANGLE[1:] + TRIANGLE[:1]
    assert measure(Scenario(TRIANGLE, (0, 0), [])) < measure(Scenario(turned, (0, 0), []))


def test_parts_of_a_list():
    for n in (0, 1, 2, 5, 64, 65, 300, 1_000):
        found = list(parts(n))
        assert all(kept == sorted(set(kept)) and len(kept) < max(n, 1) for kept in found)
        if n > 1:
            assert list(range(n // 2)) in found
            assert list(range(n - 1)) in found  # all but one
    assert all(len(kept) >= 3 for kept in parts(10, least=3))


def test_the_reference_answers_here_as_it_does_on_its_own():
    scenarios = [*TINY, *HUGE, *families()]
    output = run_trusted(REFERENCE.name, python_command(REFERENCE), render(scenarios))
    assert answers(scenarios) == read_answers(REFERENCE.name, output, len(scenarios))
