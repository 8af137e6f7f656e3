"""What a program's time grows with: the ladders, the climb, and the kit's slow submissions."""

import io
from dataclasses import replace

import pytest

from gen.scenario import parse, render
from gen.validator import load_rules, validate
from judge.decide import Judgement
from judge.explanation import Growth
from judge.kit.paths import SUBMISSIONS
from judge.languages.submission import read_submission
from judge.languages.table import LanguageError
from judge.pool import Job, Pool
from judge.problem.declaration import load
from judge.problem.verdict import Verdict
from judge.run import Attempt
from judge.sandbox.facts import Facts, RunLimits
from stress.growth import measure as measuring
from stress.growth.ladders import BY_NAME, LADDERS, exponent
from stress.growth.measure import in_order, measure
from stress.running.reference import answers

LIMITS = RunLimits(time_limit_s=5.0, memory_mib=512, output_mib=8)
SHORT = [
    replace(ladder, most=max(ladder.least, min(ladder.most, 8 * ladder.least)))
    for ladder in LADDERS
]
START_S = 0.02


def timed(cost, step_s=1e-6, verdict=Verdict.AC):
    """A program in this process that takes `step_s` for each of the steps of `cost`."""

    def attempts(contents, limits):
        for content in contents:
            seconds = START_S + step_s * cost(parse(content))
            late = seconds > limits.time_limit_s
            seconds = min(seconds, limits.time_limit_s)
            facts = Facts(0, None, seconds, seconds, 10.0, 10, None)
            yield Attempt(facts, b"", Judgement(Verdict.TLE if late else verdict, "?"))

    return attempts


def told(cost, step_s=1e-6, ladders=SHORT):
    """Return name and exponent of each ladder that grows too fast, in the order of telling."""
    growths = measure(timed(cost, step_s), LIMITS, ladders=ladders)
    return [(growth.ladder, growth.exponent) for growth in growths if growth.too_fast]


def robot(scene):
    return len(scene.robot)


def others(scene):
    return sum(map(len, scene.obstacles))


@pytest.mark.parametrize("name", BY_NAME)
def test_a_ladder_holds_valid_scenes_that_are_free_and_grow(name):
    ladder = BY_NAME[name]
    for size in (ladder.least, 4 * ladder.least):
        scenes = ladder.make(size)
        summary = validate(io.BytesIO(render(scenes)), load_rules())
        assert set(answers(scenes)) == {"YES"}
        grown = {
            "robot": max(map(robot, scenes)),
            "obstacle": min(map(len, scenes[0].obstacles)),
            "obstacles": len(scenes[0].obstacles),
            "scenarios": len(scenes),
            "move": scenes[0].move[0],
            "pair": min(robot(scenes[0]), others(scenes[0])),
        }
        grown["far-pair"] = grown["pair"]
        grown["triangles"] = grown["wide-triangles"] = grown["robot"]
        assert grown[name] == size
        if "triangles" in name:
            assert len(scenes[0].obstacles) == size // 3
        assert summary.vertices <= 21 * size + 100
    assert ladder.most <= 100_000 or name == "move"


@pytest.mark.slow
@pytest.mark.parametrize("name", BY_NAME)
def test_the_largest_scene_of_a_ladder_is_valid(name):
    validate(io.BytesIO(render(BY_NAME[name].make(BY_NAME[name].most))), load_rules())


@pytest.mark.parametrize(
    ("cost", "names"),
    [
        (lambda scenes: sum(robot(s) + others(s) for s in scenes), []),
        (lambda scenes: sum(robot(s) * others(s) for s in scenes), ["pair", "triangles"]),
        (lambda scenes: sum(3 * robot(s) * len(s.obstacles) for s in scenes), ["triangles"]),
        (lambda scenes: len(scenes) ** 2, ["scenarios"]),
        (lambda scenes: sum(len(s.obstacles) ** 2 for s in scenes), ["obstacles"]),
        (lambda scenes: sum(max(map(abs, s.move)) for s in scenes), ["move"]),
    ],
    ids=["linear", "m * n", "k * m", "t * t", "k * k", "the move"],
)
def test_the_quantity_that_makes_the_time_grow_is_found(cost, names):
    found = told(cost)
    assert [name for name, _ in found][: len(names) or 1] == names
    assert all(abs(b - (1 if name == "move" else 2)) < 0.2 for name, b in found)


def test_the_simplest_of_several_causes_is_told_with_the_fastest_first():
    found = told(lambda scenes: sum(robot(s) ** 2 * len(s.obstacles) for s in scenes), 2e-7)
    assert found[0][0] == "triangles"
    assert found[0][1] > 2.7
    assert ("robot", 2.0) in found


def test_a_climb_ends_at_the_time_limit_and_before_it_where_that_is_foreseen():
    runs = []

    def attempts(contents, limits):
        for attempt in timed(lambda scenes: robot(scenes[0]) ** 2, 1e-6)(contents, limits):
            runs.append(attempt)
            yield attempt

    (growth,) = measure(attempts, LIMITS, ladders=[replace(BY_NAME["robot"], least=300)])
    assert growth.sizes == (300, 600, 1200)  # 2,400 would take 5.8 s
    assert growth.cpu_s == (0.09, 0.36, 1.44)
    assert (growth.exponent, growth.too_fast, growth.over) == (2.0, True, None)
    assert len(runs) == 3 + 3
    (jump,) = measure(
        timed(lambda scenes: robot(scenes[0]) ** 4, 3e-12), LIMITS, ladders=[BY_NAME["robot"]]
    )
    assert (jump.sizes, jump.over) == ((512,), 1024)  # four times 256 is too much


def test_a_program_that_never_ends_or_crashes_has_no_exponent():
    stuck = measure(timed(lambda _scenes: 1e9), LIMITS, ladders=SHORT)
    assert [growth.over for growth in stuck[:2]] == [16, 16]
    assert {(growth.sizes, growth.exponent, growth.too_fast) for growth in stuck} == {
        ((), None, False)
    }
    crashed = measure(timed(lambda _scenes: 1, verdict=Verdict.RTE), LIMITS, ladders=SHORT)
    assert {(growth.sizes, growth.over) for growth in crashed} == {((), None)}


def test_nothing_new_begins_when_the_time_is_over(monkeypatch):
    monkeypatch.setattr(measuring, "ELAPSED_S", 0.0)
    assert {g.sizes for g in measure(timed(lambda _scenes: 1), LIMITS, ladders=SHORT)} == {()}


def test_the_order_of_telling():
    def growth(name, b, fast=True, may=1.0):
        return Growth(name, name, (1, 2), (1.0, 2.0), None, b, may, fast)

    a, b, c, d = growth("a", 1.9), growth("b", 3.0), growth("c", 2.9), growth("d", 1.0, False)
    assert in_order([d, a, b, c]) == (b, c, a, d)
    assert in_order([c, a, b]) == (c, b, a)  # about alike: the earlier one is simpler
    move = growth("move", 1.0, may=0.0)
    assert in_order([move, a]) == (move, a)


def test_the_exponent_of_a_power():
    assert exponent([10, 20, 40], [1.0, 8.0, 64.0]) == 3


@pytest.fixture
def patient(monkeypatch):
    """A busy machine is no reason to fail."""
    monkeypatch.setattr(measuring, "ELAPSED_S", 90.0)
    monkeypatch.setattr(measuring, "RUN_S", 4.0)


def measured(submission, ladders):
    with Pool(Job(submission, load(), without_wall=True, keepers=2), 2) as pool:
        try:
            pool.result(pool.prepare())
        except LanguageError as error:
            pytest.skip(str(error))
        return measure(pool.attempts, LIMITS, ladders=ladders)


def test_a_real_program_is_measured(tmp_path, patient):
    """Quadratic in the obstacle's vertices, and hardly anything else."""
    program = tmp_path / "slow.py"
    program.write_text(
        "import sys, time\nn = len(sys.stdin.readlines())\nstart = time.process_time()\n"
        "while time.process_time() - start < 3e-8 * n * n: pass\nprint('YES')\n"
    )
    few = replace(BY_NAME["obstacle"], least=50, most=200)
    (growth,) = measured(read_submission(program), [few])
    assert growth.too_fast
    assert 1.7 < growth.exponent < 2.3


# What the first lines of each say: which ladders its time climbs too fast, and about how fast.
DIRECTIONS = {
    "all_pairs_hull.cpp": {"pair": 2, "triangles": 2},  # O(m n log(m n)) for each obstacle
    "brute_force.cpp": {"pair": 2, "triangles": 2},  # O(m n) for each obstacle
    "brute_force_boxes.cpp": {"triangles": 2},  # boxes decide nothing where all boxes overlap
    "brute_force_grid.cpp": {"far-pair": 2},  # long moves: everything lies in a few cells
    "brute_force_sweep_line.cpp": {"far-pair": 2},  # long moves cross all trails at once
    "separating_axes.cpp": {"robot": 2, "triangles": 3},  # O((m + n)^2) for each
    "sweep_per_obstacle.cpp": {"triangles": 2},  # O(k m log m)
    "textbook_boxes.cpp": {"triangles": 2},  # O(k m + N) where all boxes overlap
    "textbook_windows.cpp": {"wide-triangles": 2},  # O(k m) where obstacles are wide
}
NOT = {  # what they get right
    "sweep_per_obstacle.cpp": {"pair", "robot", "obstacle"},
    "textbook_boxes.cpp": {"pair", "robot", "obstacle"},
    "textbook_windows.cpp": {"pair", "robot", "obstacle", "triangles"},
    "brute_force_grid.cpp": {"pair", "robot", "obstacle"},
    "brute_force_sweep_line.cpp": {"pair", "robot", "obstacle"},
}


def test_every_slow_submission_has_its_direction_here():
    names = {path.name for path in (SUBMISSIONS / "time_limit_exceeded").iterdir()}
    assert names == set(DIRECTIONS)


@pytest.mark.slow
@pytest.mark.usefixtures("compiled_once")
@pytest.mark.parametrize("name", DIRECTIONS)
def test_the_direction_of_a_slow_submission_is_true(name, patient):
    submission = read_submission(SUBMISSIONS / "time_limit_exceeded" / name)
    climbed = {*DIRECTIONS[name], *NOT.get(name, ())}
    growths = measured(submission, [BY_NAME[ladder] for ladder in climbed])
    found = {growth.ladder: growth.exponent for growth in growths if growth.too_fast}
    assert found.keys() == DIRECTIONS[name].keys()
    for ladder, expected in DIRECTIONS[name].items():
        assert expected - 0.6 < found[ladder] < expected + 1, ladder  # caches make it grow faster
