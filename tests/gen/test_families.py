"""Every family: valid files, equal seeds equal bytes, and what its name promises."""

import io
import os
import subprocess
import sys

import pytest

from gen.families import FAMILIES, FamilyError, find
from gen.geometry import apart, cross, minus, sweep
from gen.rng import Rng, derive
from gen.scenario import LIMIT, parse, render
from gen.validator import load_rules, validate
from judge.kit.paths import ROOT

# Whole worlds and whole files are not needed to see whether a family works.
LITTLE = {"world": {"vertices": 3_000}, "wedges": {"vertices": 700}, "flats": {"vertices": 700}}
RARE_SEEDS = (10**20, -1)  # of each family, slow tests


def made(name, seed=1, **parameters):
    return find(name).scenarios({**LITTLE.get(name, {}), **parameters}, seed)


def free(scenario):
    covered = sweep(scenario.robot, scenario.move).vertices
    return all(apart(covered, obstacle) for obstacle in scenario.obstacles)


@pytest.mark.parametrize(
    "seed", [1, 2, 3, *(pytest.param(seed, marks=pytest.mark.slow) for seed in RARE_SEEDS)]
)
@pytest.mark.parametrize("name", FAMILIES)
def test_files_are_valid(name, seed):
    scenarios = made(name, seed)
    content = render(scenarios)
    summary = validate(io.BytesIO(content), load_rules())
    assert summary.scenarios == len(scenarios) > 0
    assert parse(content) == scenarios


@pytest.mark.parametrize("name", FAMILIES)
def test_both_answers_occur_about_equally_often(name):
    answers = [free(scenario) for seed in range(3) for scenario in made(name, seed)]
    share = {"world": 0.1}.get(name, 0.3)
    assert share <= sum(answers) / len(answers) <= 1 - share


@pytest.mark.parametrize("name", [name for name in FAMILIES if "move" in FAMILIES[name].defaults])
def test_nothing_moves_when_asked(name):
    assert all(scenario.move == (0, 0) for scenario in made(name, move="zero"))


def test_equal_seeds_give_equal_bytes_whatever_the_hash_seed():
    program = (
        "from gen.families import FAMILIES; from gen.scenario import render; import hashlib\n"
        "for name, family in FAMILIES.items():\n"
        "    few = {'vertices': 600} if 'vertices' in family.defaults else {}\n"
        "    scenes = family.scenarios(few, 5)\n"
        "    print(name, hashlib.sha256(render(scenes)).hexdigest())\n"
    )
    runs = [
        subprocess.Popen(
            [sys.executable, "-c", program],
            env={**os.environ, "PYTHONHASHSEED": seed},
            cwd=ROOT,
            stdout=subprocess.PIPE,
        )
        for seed in ("0", "1", "4242")
    ]
    outputs = {run.communicate()[0] for run in runs}
    assert [run.returncode for run in runs] == [0, 0, 0]
    assert len(outputs) == 1
    assert len({line.split()[1] for line in outputs.pop().splitlines()}) == len(FAMILIES)


def test_seeds_depend_on_everything_but_the_order_of_parameters():
    base = derive("contacts", {"a": 1, "b": 2}, 1)
    assert base == derive("contacts", {"b": 2, "a": 1}, 1)
    others = [
        derive("contact", {"a": 1, "b": 2}, 1),
        derive("contacts", {"a": 2, "b": 2}, 1),
        derive("contacts", {"a": 1, "b": 2}, 2),
    ]
    assert len({base, *others}) == 4
    # The bytes of every case hang on these: a change here changes all of the data.
    assert derive("contacts", {"a": 1}, 1) == 12711458464329787244


def test_the_random_source_is_stable():
    rng = Rng(7)
    assert [rng.below(1_000) for _ in range(5)] == [331, 970, 154, 404, 666]
    with pytest.raises(ValueError, match="n >= 1, found 0"):
        rng.below(0)
    with pytest.raises(ValueError, match="at most 2 items, found 3"):
        rng.subset([1, 2], 3)


def test_contacts_come_in_pairs_that_differ_in_one_obstacle():
    answers = [free(scenario) for scenario in made("contacts", vertices=20_000)]
    assert all(a != b for a, b in zip(answers[::2], answers[1::2], strict=False))


def test_corners_reach_the_limit_exactly():
    for scenario in made("contacts", corner=1):
        end = [(x + scenario.move[0], y + scenario.move[1]) for x, y in scenario.robot]
        everything = [*scenario.robot, *end, *(v for o in scenario.obstacles for v in o)]
        assert max(abs(x) for x, _ in everything) == LIMIT
        assert max(abs(y) for _, y in everything) == LIMIT


def test_hugging_obstacles_have_the_size_asked_for_and_one_decides():
    scenarios = made("hugging", scenarios=4, m=120, obstacles=20, n=9, deciding="last")
    for scenario in scenarios:
        assert len(scenario.robot) == 120
        assert [len(obstacle) for obstacle in scenario.obstacles] == [9] * 20
        covered = sweep(scenario.robot, scenario.move).vertices
        assert [apart(covered, o) for o in scenario.obstacles] == [True] * 19 + [False]


def test_hugging_stands_still_when_the_move_is_not_far():
    assert [scenario.move for scenario in made("hugging", far=0)] == [(0, 0)] * 2


def test_slivers_are_long_and_as_narrow_as_the_grid_allows():
    for scenario in made("slivers"):
        directions = edges(scenario.robot) + [e for o in scenario.obstacles for e in edges(o)]
        directions += [scenario.move] * (scenario.move != (0, 0))
        long = [v for v in directions if max(map(abs, v)) >= LIMIT // 4]
        assert any(abs(cross(a, b)) == 1 for a in long for b in long)


def test_cuts_leave_no_vertex_of_an_obstacle_inside_the_sweep():
    for scenario in made("cuts"):
        covered = sweep(scenario.robot, scenario.move).vertices
        for vertex in (v for obstacle in scenario.obstacles for v in obstacle):
            ends = zip([covered[-1], *covered], covered, strict=False)
            assert any(cross(minus(b, a), minus(vertex, a)) <= 0 for a, b in ends)


def edges(polygon):
    return [minus(b, a) for a, b in zip([polygon[-1], *polygon], polygon, strict=False)]


def test_mixtures_fill_the_file_exactly():
    assert sum(scenario.vertices for scenario in made("mixture")) == 2_000


def test_the_smallest_world_is_complete():
    # 5 shapes in a box of 1 up to translation; two boxes of 1 meet in 9 places.
    assert len(made("world", far=0)) == 5 * 5 * 9


@pytest.mark.parametrize(
    ("family", "parameters", "message"),
    [
        ("contcats", {}, "no family 'contcats'; did you mean 'contacts'?"),
        ("contacts", {"reech": 1}, "family contacts: no parameter 'reech'; did you mean 'reach'?"),
        ("contacts", {"reach": "x"}, "parameter reach: expected an integer of 1.."),
        ("contacts", {"reach": "9" * 5_000}, "parameter reach: expected an integer of 1.."),
        ("contacts", {"reach": 0}, "parameter reach: expected an integer of 1.."),
        ("contacts", {"move": "zeros"}, "expected one of mixed, zero, axis"),
        ("parallel", {"reach": 10_000, "stretch": 2 * 10**8}, "no scene fits the world"),
    ],
)
def test_bad_parameters_are_explained(family, parameters, message, monkeypatch):
    monkeypatch.setattr("gen.families.common._MOST_TRIES", 300)
    with pytest.raises(FamilyError) as caught:
        find(family).scenarios(parameters, 1)
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)
