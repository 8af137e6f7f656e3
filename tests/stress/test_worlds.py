"""The scenarios that solvers are compared on."""

from itertools import islice

from gen.geometry import is_strictly_convex
from gen.scenario import render
from stress.worlds import grid_polygons, random_scenarios, small_world


def test_grid_polygons_are_all_there_and_no_other():
    # 3 x 3: C(9, 3) = 84 triples, less 8 on a line, are 76 triangles.
    polygons = grid_polygons(3)
    assert [sum(len(p) == n for p in polygons) for n in (3, 4, 5, 6, 7)] == [76, 70, 20, 2, 0]
    assert all(map(is_strictly_convex, polygons))
    assert len({frozenset(p) for p in polygons}) == len(polygons) == 168


def test_the_small_world_has_the_size_that_is_claimed():
    # 4 polygons on 2 x 2 grids and the square: 5; offsets (a, b) with 0 <= b <= a <= 2: 6.
    world = list(small_world(2, 1))
    assert len(world) == 6 * 5 * 5 * 9
    assert len({(s.move, frozenset(s.robot), frozenset(s.obstacles[0])) for s in world}) == 1350
    assert {s.robot[0] for s in world} == {(0, 0), (0, 1), (1, 0), (1, 1)}


def test_equal_seeds_give_equal_scenarios():
    def content(seed):
        return render(list(random_scenarios(seed, 300)))

    assert content(5) == content(5)
    assert content(5) != content(6)


def test_random_scenarios_cover_what_matters():
    scenarios = list(islice(random_scenarios(1, 4_000), 4_000))
    assert {len(s.obstacles) for s in scenarios} == {0, 1, 2, 3}
    assert any(s.move == (0, 0) for s in scenarios)
    assert all(is_strictly_convex(p) for s in scenarios for p in [s.robot, *s.obstacles])
