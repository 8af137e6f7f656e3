"""The generators' own geometry, against slower twins."""

from itertools import pairwise
from math import gcd

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gen.families.unforeseen.rooms import star
from gen.geometry import (
    apart,
    cross,
    hull,
    is_strictly_convex,
    primitive,
    step_right,
    sweep,
    translated,
)
from gen.geometry.decompose import convex_pieces
from gen.rng import Rng
from gen.scenario import LIMIT, Scenario, bounds, disguised, moved, settled
from gen.shapes.convex import arc, in_box, many_gon, near_circle, needle, random_convex
from gen.shapes.edges import (
    angle_key,
    closed,
    directions,
    directions_from,
    number_of_directions,
)
from gen.shapes.grids import grid_polygons

SEEDS = st.integers(0, 10**9)
VECTORS = st.tuples(st.integers(-50, 50), st.integers(-50, 50)).filter(any)


def twice_area(polygon):
    return sum(cross(polygon[i - 1], polygon[i]) for i in range(len(polygon)))


@given(VECTORS)
def test_a_step_right_reaches_the_next_lattice_line(vector):
    along = primitive(vector)
    right = step_right(along)
    assert cross(along, right) == -1
    assert 0 <= along[0] * right[0] + along[1] * right[1] < along[0] ** 2 + along[1] ** 2


@given(SEEDS, st.integers(-6, 6), st.integers(-6, 6))
def test_a_sweep_is_the_hull_of_both_ends(seed, dx, dy):
    robot = in_box(Rng(seed), 6, 7)
    covered = sweep(robot, (dx, dy))
    assert is_strictly_convex(covered.vertices)
    assert set(covered.vertices) == set(hull(robot + translated(robot, (dx, dy))))


@given(SEEDS)
def test_polygons_are_apart_when_no_lattice_refinement_finds_a_common_point(seed):
    rng = Rng(seed)
    a = in_box(rng, 4, 5)
    b = translated(in_box(rng, 4, 5), (rng.between(-5, 5), rng.between(-5, 5)))
    # Convex a and b meet if and only if the hull of their difference holds the origin.
    difference = hull([(p[0] - q[0], p[1] - q[1]) for p in a for q in b])
    turns = [cross(difference[i - 1], difference[i]) for i in range(len(difference))]
    assert apart(a, b) == (min(turns) < 0)


@pytest.mark.parametrize(
    ("polygon", "good"),
    [
        ([(0, 0), (1, 0), (0, 1)], True),
        ([(0, 0), (0, 1), (1, 0)], False),  # clockwise
        ([(0, 0), (1, 0), (2, 0), (0, 1)], False),  # straight corner
        ([(0, 0), (1, 0)], False),
        ([(0, 3), (-2, -3), (3, 1), (-3, 1), (2, -3)], False),  # a pentagram turns left only
        ([(0, 0), (4, 0), (1, 1), (0, 4)], False),
    ],
)
def test_strict_convexity(polygon, good):
    assert is_strictly_convex(polygon) == good


@pytest.mark.parametrize("reach", [1, 2, 3, 7, 20])
def test_directions_are_all_primitive_vectors_by_angle(reach):
    span = range(-reach, reach + 1)
    found = directions(reach)
    assert set(found) == {(x, y) for x in span for y in span if gcd(x, y) == 1}
    keys = [angle_key(v) for v in found]
    assert keys == sorted(set(keys))


@pytest.mark.parametrize("reach", [1, 2, 3, 7, 20])
def test_some_of_the_directions_are_made_as_in_all_of_them(reach):
    every = directions(reach)
    assert number_of_directions(reach) == len(every)
    for start in range(0, len(every), 1 + len(every) // 50):
        for count in (0, 1, 5, len(every)):
            assert directions_from(reach, start, count) == list((every + every)[start:][:count])


@given(SEEDS, st.integers(2, 30))
def test_edges_are_closed_to_a_convex_polygon(seed, n):
    edges = Rng(seed).subset(directions(4), n)
    polygon = closed(edges)
    if polygon:
        assert is_strictly_convex(polygon)
        assert polygon[0] == (0, 0) == min(polygon, key=lambda v: (v[1], v[0]))
        found = [(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(polygon)]
        found.append((-polygon[-1][0], -polygon[-1][1]))
        assert len({primitive(edge) for edge in [*found, *edges]}) <= len(edges) + 1
    else:
        assert all(cross(edges[0], edge) == 0 for edge in edges)


def test_all_polygons_of_a_small_grid_are_there():
    assert len(grid_polygons(2)) == 5
    polygons = grid_polygons(3)
    assert len(polygons) == len(set(map(tuple, polygons))) == 168
    assert all(map(is_strictly_convex, polygons))


@given(SEEDS)
def test_several_draws_are_those_of_one_after_the_other(seed):
    rng = Rng(seed)
    assert Rng(seed).several(20, -7, 5) == [rng.between(-7, 5) for _ in range(20)]


@given(SEEDS, st.booleans())
def test_a_disguised_scene_asks_the_same_question(seed, corner):
    rng = Rng(seed)
    robot, obstacle = in_box(rng, 6, 6), translated(in_box(rng, 6, 6), (rng.below(9), 3))
    scenario = Scenario(robot, (rng.between(-9, 9), rng.between(-9, 9)), [obstacle])
    disguise = disguised(rng, scenario)
    assert bounds(disguise) == bounds(moved(disguise, (0, 0)))
    placed = settled(rng, disguise, corner=corner)
    for polygon, original in zip([placed.robot, *placed.obstacles], [robot, obstacle], strict=True):
        assert is_strictly_convex(polygon)
        assert twice_area(polygon) == twice_area(original)
    answers = [apart(sweep(s.robot, s.move).vertices, s.obstacles[0]) for s in (scenario, placed)]
    assert answers[0] == answers[1]
    left, bottom, right, top = bounds(placed)
    assert max(-left, right, -bottom, top) <= LIMIT
    assert not corner or (LIMIT in (-left, right) and LIMIT in (-bottom, top))


@pytest.mark.parametrize("n", [3, 4, 5, 6, 7, 12, 100, 3_000])
@pytest.mark.parametrize("make", [random_convex, near_circle, arc])
def test_shapes_have_exactly_n_vertices(make, n):
    for seed in range(3):
        polygon = make(Rng(seed), n)
        assert len(polygon) == n
        assert is_strictly_convex(polygon)


def test_the_largest_shapes_fit_the_world():
    for make in (random_convex, near_circle):
        polygon = make(Rng(1), 250_000)
        assert len(polygon) == 250_000
        assert is_strictly_convex(polygon)
        assert all(max(axis) - min(axis) < 2 * 10**8 for axis in zip(*polygon, strict=True))


@given(SEEDS, VECTORS)
def test_needles_have_area_one_half(seed, vector):
    assert twice_area(needle(Rng(seed), primitive(vector))) == 1


@given(SEEDS, st.integers(3, 9))
def test_many_gons_are_parallel_but_for_one_edge(seed, n):
    edges = list(directions(2))
    polygon = many_gon(Rng(seed), edges, n, 4)
    assert is_strictly_convex(polygon)
    foreign = [
        i
        for i, (x, y) in enumerate(polygon)
        if primitive((x - polygon[i - 1][0], y - polygon[i - 1][1])) not in edges
    ]
    assert len(polygon) <= n
    assert len(foreign) <= 1


@given(SEEDS)
def test_stars_are_cut_into_convex_pieces_that_cover_them_exactly(seed):
    ring = star(Rng(seed), 14, 12)
    pieces = convex_pieces(ring)
    assert all(map(is_strictly_convex, pieces))
    assert sum(map(twice_area, pieces)) == twice_area(ring)
    assert {vertex for piece in pieces for vertex in piece} <= set(ring)
