"""The generators' own geometry, against slower twins."""

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
from gen.shapes.convex import arc, in_box, many_gon, near_circle, needle, random_convex
from gen.shapes.edges import angle_key, directions

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
