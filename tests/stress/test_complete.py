"""Complete worlds in C++: that they are complete, and that the programs agree on them."""

from itertools import product

import pytest

from gen.geometry import hull, is_strictly_convex
from gen.parse import parse
from gen.scenario import Scenario
from judge.languages.table import LanguageError
from judge.problem.declaration import load
from judge.sandbox.sandbox import Sandbox
from stress import complete
from stress.agree import SOLVERS
from stress.complete import WORLDS, World, compare_world, compiled, size
from stress.worlds import grid_polygons

PROBLEM = load()


@pytest.fixture(scope="module")
def programs():
    with Sandbox() as sandbox:
        try:
            yield compiled(PROBLEM, sandbox)
        except LanguageError as error:
            pytest.skip(str(error))


def scenes(programs, world):
    """All scenarios of a world, as the maker prints them."""
    arguments = [*world.arguments, "0", str(size(world, programs))]
    return parse(complete._run([*programs.maker, *arguments], b""))


def free(scenario):
    """A scenario without its dress: the least of its images, pushed to the axes."""
    images = []
    for flip_x, flip_y, swap in product((1, -1), (1, -1), (False, True)):

        def image(point, flips=(flip_x, flip_y), swap=swap):
            x, y = point[0] * flips[0], point[1] * flips[1]
            return (y, x) if swap else (x, y)

        robot = sorted(map(image, scenario.robot))
        left, low = min(x for x, _ in robot), min(y for _, y in robot)
        obstacle = sorted(map(image, scenario.obstacles[0]))
        images.append(
            (
                tuple((x - left, y - low) for x, y in robot),
                tuple((x - left, y - low) for x, y in obstacle),
                image(scenario.move),
            )
        )
    return min(images)


def enumerated(side, reach):
    """All scenarios of the world by other means: every placed pair, every move; boxes meet."""
    found = set()
    for robot, shape in product(grid_polygons(side), repeat=2):
        for dx, dy in product(range(-reach, reach + 1), repeat=2):
            for x, y in product(range(-2 * side - reach, 2 * side + reach), repeat=2):
                obstacle = [(px + x, py + y) for px, py in shape]
                xs, ys = zip(*robot, strict=True)
                qx, qy = zip(*obstacle, strict=True)
                if (
                    min(xs) + min(dx, 0) <= max(qx)
                    and max(xs) + max(dx, 0) >= min(qx)
                    and min(ys) + min(dy, 0) <= max(qy)
                    and max(ys) + max(dy, 0) >= min(qy)
                ):
                    found.add((tuple(robot), tuple(obstacle), (dx, dy)))
    return found


def test_the_smallest_world_holds_every_scenario_up_to_symmetry(programs):
    made = {free(scenario) for scenario in scenes(programs, World(2, 2, 1))}
    every = {free(Scenario(list(r), d, [list(o)])) for r, o, d in enumerated(2, 1)}
    assert made == every


def test_the_dresses_are_valid_and_all_occur(programs):
    every = scenes(programs, World(2, 2, 4))
    assert len(every) == 22_090
    for scenario in every:
        for polygon in (scenario.robot, *scenario.obstacles):
            assert is_strictly_convex(polygon)
    # Every vertex of the unit square comes first somewhere.
    squares = [s.robot for s in every if len(s.robot) == 4]
    assert len({tuple(a - b for a, b in zip(r[0], min(r), strict=True)) for r in squares}) == 4


def test_the_shapes_that_the_sizes_stand_on():
    # 4 x 4: 1,633 shapes up to translation, which the world's size stands on.
    pushed = {
        frozenset((x - min(p)[0], y - min(q[1] for q in p)) for x, y in p) for p in grid_polygons(4)
    }
    assert len(pushed) == 1_633
    assert all(len(hull(list(p))) == len(p) for p in pushed)


def test_sizes(programs):
    assert [size(world, programs) for world in WORLDS] == [
        22_090,
        11_276_948,
        33_252_227,
        46_140_200,
        182_947_493,
    ]


def test_all_programs_agree_on_a_complete_world(programs):
    outcome = compare_world(WORLDS[0], programs, jobs=2, part=5_000, python_every=2)
    assert outcome.disagreement is None
    assert outcome.scenarios == 22_090
    assert outcome.by_python == 12_090  # parts 0, 2 and the short one, 4


@pytest.mark.parametrize("world", WORLDS[1:], ids=str)
def test_all_programs_agree_on_a_sample_of_the_larger_worlds(programs, world):
    every = size(world, programs) // 2_500 // 4
    outcome = compare_world(
        world, programs, jobs=2, part=2_500, only_every=every, python_every=every
    )
    assert outcome.disagreement is None
    assert outcome.by_python == outcome.scenarios >= 10_000
    assert outcome.yes > 500


def test_a_difference_is_found(programs):
    with Sandbox() as sandbox:
        wrong = complete.ROOT / "submissions" / "wrong_answer" / "axes_touch_free.cpp"
        both = compiled(PROBLEM, sandbox, [complete.CPP_SOLVERS[0], wrong], SOLVERS[:1])
        outcome = compare_world(WORLDS[0], both, jobs=1)
    assert outcome.disagreement is not None
    assert outcome.disagreement.answers == {"textbook.cpp": "NO", "axes_touch_free.cpp": "YES"}
