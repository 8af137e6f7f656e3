"""The scenarios that programs are compared on."""

from collections import Counter
from itertools import product

import pytest

from gen.geometry import hull, is_strictly_convex
from gen.scenario import Scenario, parse
from gen.shapes.grids import grid_polygons
from stress.chance import random_files, random_scenarios
from stress.cli import COMPLETE
from stress.worlds import box_world, grid_world


def scenes(world):
    """All scenarios of a world."""
    content, count = world.file(0, world.size)
    scenarios = parse(content)
    assert len(scenarios) == count == world.size
    return scenarios


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


def test_the_smallest_world_holds_every_scenario_up_to_symmetry():
    made = {free(scenario) for scenario in scenes(box_world(2, 2, 1))}
    every = {free(Scenario(list(r), d, [list(o)])) for r, o, d in enumerated(2, 1)}
    assert made == every


def test_the_dresses_are_valid_and_all_occur():
    every = scenes(box_world(2, 2, 4))
    assert len(every) == 22_090
    for scenario in every:
        for polygon in (scenario.robot, *scenario.obstacles):
            assert is_strictly_convex(polygon)
    # Every vertex of the unit square comes first somewhere, in every corner of the axes.
    squares = Counter(tuple(s.robot) for s in every if len(s.robot) == 4)
    assert len(squares) == 16
    squares = Counter(tuple(s.obstacles[0]) for s in every if len(s.obstacles[0]) == 4)
    firsts = {tuple(a - b for a, b in zip(q[0], min(q), strict=True)) for q in squares}
    assert len(firsts) == 4


def test_the_shapes_that_the_sizes_stand_on():
    # 4 x 4: 1,633 shapes up to translation, which the world's size stands on.
    pushed = {
        frozenset((x - min(p)[0], y - min(q[1] for q in p)) for x, y in p) for p in grid_polygons(4)
    }
    assert len(pushed) == 1_633
    assert all(len(hull(list(p))) == len(p) for p in pushed)


def test_sizes():
    assert [box_world(*world).size for world in COMPLETE] == [
        22_090,
        11_276_948,
        33_252_227,
        46_140_200,
        182_947_493,
    ]
    assert grid_world(3, 2).size == 7_056_000


@pytest.mark.parametrize("world", [box_world(2, 2, 2), grid_world(2, 1)], ids=str)
def test_every_part_of_a_world_is_the_same_as_in_the_whole(world):
    whole = world.file(0, world.size).content.splitlines()
    for scenarios in (1_000, 77):
        parts = [world.file(start, scenarios) for start in range(0, world.size, scenarios)]
        assert [part.scenarios for part in parts[:-1]] == [scenarios] * (len(parts) - 1)
        assert parts == list(world.files(scenarios))
        lines = [line for part in parts for line in part.content.splitlines()[1:]]
        assert lines == whole[1:]
    assert list(world.files(77, every=5)) == parts[::5]


def test_grid_polygons_are_all_there_and_no_other():
    # 3 x 3: C(9, 3) = 84 triples, less 8 on a line, are 76 triangles.
    polygons = grid_polygons(3)
    assert [sum(len(p) == n for p in polygons) for n in (3, 4, 5, 6, 7)] == [76, 70, 20, 2, 0]
    assert all(map(is_strictly_convex, polygons))
    assert len({frozenset(p) for p in polygons}) == len(polygons) == 168


def test_the_small_world_has_the_size_that_is_claimed():
    # 4 polygons on 2 x 2 grids and the square: 5; offsets (a, b) with 0 <= b <= a <= 2: 6.
    world = scenes(grid_world(2, 1))
    assert len(world) == 6 * 5 * 5 * 9
    assert len({(s.move, frozenset(s.robot), frozenset(s.obstacles[0])) for s in world}) == 1350
    assert {s.robot[0] for s in world} == {(0, 0), (0, 1), (1, 0), (1, 1)}


def test_equal_seeds_give_equal_scenarios():
    def content(seed):
        return list(random_files(seed, 300))

    assert content(5) == content(5)
    assert content(5) != content(6)


def test_random_scenarios_cover_what_matters():
    scenarios = list(random_scenarios(1, 4_000))
    assert {len(s.obstacles) for s in scenarios} == {0, 1, 2, 3}
    assert any(s.move == (0, 0) for s in scenarios)
    assert all(is_strictly_convex(p) for s in scenarios for p in [s.robot, *s.obstacles])
