"""The decisive moment, against the Minkowski difference built in full and clipped edge by edge."""

from fractions import Fraction

import pytest

import brute
from gen.geometry import hull, translated
from gen.scenario import LIMIT, Scenario
from pictures.exact import extremes, search
from pictures.moment import Approach, Contact, Kind, decisive
from stress.chance import random_scenarios

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
UNTOUCHED_PARTS = {Kind.OVERLAP, Kind.ROBOT_INSIDE, Kind.OBSTACLE_INSIDE}


def edges(polygon):
    return list(zip(polygon, polygon[1:] + polygon[:1], strict=True))


def side(a, b, p):
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def inside(polygon, p, *, strictly=False):
    return all(side(a, b, p) >= strictly for a, b in edges(polygon))


def difference(robot, obstacle):
    return hull([(x - a, y - b) for x, y in obstacle for a, b in robot])


def first_time(polygon, move):
    """The least t in [0, 1] with t * move in the polygon, or None."""
    low, high = Fraction(0), Fraction(1)
    for a, b in edges(polygon):
        pace = (b[0] - a[0]) * move[1] - (b[1] - a[1]) * move[0]
        level = -side(a, b, (0, 0))
        if pace > 0:
            low = max(low, Fraction(level, pace))
        elif pace < 0:
            high = min(high, Fraction(level, pace))
        elif level > 0:
            return None
    return low if low <= high else None


def squared(p, segment):
    """The squared distance of a point from a segment, or from a corner."""
    (ax, ay), (bx, by) = segment[0], segment[-1]
    ux, uy = bx - ax, by - ay
    length = ux * ux + uy * uy
    t = Fraction((p[0] - ax) * ux + (p[1] - ay) * uy) / length if length else Fraction(0)
    t = min(max(t, Fraction(0)), Fraction(1))
    return (ax + t * ux - p[0]) ** 2 + (ay + t * uy - p[1]) ** 2


def distance(one, other):
    return min(
        min(squared(p, edge) for p in a for edge in edges(b))
        for a, b in ((one, other), (other, one))
    )


def at(points, move, time):
    return [(x + time * move[0], y + time * move[1]) for x, y in points]


def check(scenario):
    found, move = decisive(scenario), scenario.move
    if not scenario.obstacles:
        assert found is None
        return
    areas = [difference(scenario.robot, q) for q in scenario.obstacles]
    times = [(first_time(area, move), j) for j, area in enumerate(areas)]
    hits = [hit for hit in times if hit[0] is not None]
    polygon = scenario.obstacles[found.obstacle]
    robot = at(scenario.robot, move, found.time)
    assert set(found.robot) <= set(scenario.robot)
    assert set(found.feature) <= set(polygon)
    if hits:
        assert isinstance(found, Contact)
        assert (found.time, found.obstacle) == min(hits)
        assert inside(robot, found.point)
        assert inside(polygon, found.point)
        overlaps = inside(areas[found.obstacle], (0, 0), strictly=True)
        assert overlaps == (found.kind in UNTOUCHED_PARTS)
        robot_inside = all(inside(polygon, p) for p in scenario.robot)
        obstacle_inside = all(inside(scenario.robot, p) for p in polygon)
        assert (found.kind is Kind.ROBOT_INSIDE) == (overlaps and robot_inside)
        if not robot_inside:
            assert (found.kind is Kind.OBSTACLE_INSIDE) == (overlaps and obstacle_inside)
        if found.robot and found.feature:
            assert squared(found.point, at(found.robot, move, found.time)) == 0
            assert squared(found.point, found.feature) == 0
    else:
        assert isinstance(found, Approach)
        covered = hull(scenario.robot + translated(scenario.robot, move))
        gaps = [(distance(covered, q), j) for j, q in enumerate(scenario.obstacles)]
        assert (found.squared, found.obstacle) == min(gaps)
        (ax, ay), (bx, by) = found.robot_point, found.point
        assert (ax - bx) ** 2 + (ay - by) ** 2 == found.squared
        assert squared(found.robot_point, at(found.robot, move, found.time)) == 0
        assert squared(found.point, found.feature) == 0
        earlier = found.time * Fraction(999, 1000)
        if found.time:
            assert distance(at(scenario.robot, move, earlier), polygon) > found.squared


@pytest.mark.parametrize("small", [0, extremes.SMALL])  # 0: also triangles are searched
def test_random_scenarios(monkeypatch, small):
    monkeypatch.setattr(extremes, "SMALL", small)
    for scenario in random_scenarios(small, 250):
        check(scenario)


@pytest.mark.slow
def test_many_random_scenarios():
    for scenario in random_scenarios(99, 5000):
        check(scenario)


def test_the_answers_of_the_brute_force():
    for scenario in random_scenarios(5, 2000):
        hit = any(brute.collide(scenario.robot, q, *scenario.move) for q in scenario.obstacles)
        assert isinstance(decisive(scenario), Contact) == hit


def test_with_a_sieve_for_many_obstacles(monkeypatch):
    monkeypatch.setattr(search, "SIEVE_FROM", 0)
    crowd = [s for s in random_scenarios(11, 1000) if s.obstacles]
    for i in range(0, len(crowd) - 20, 20):
        shapes = [q for scenario in crowd[i : i + 20] for q in scenario.obstacles]
        far = [translated(q, (9 * j % 80 - 40, 15 - j % 31)) for j, q in enumerate(shapes)]
        check(Scenario(crowd[i].robot, crowd[i].move, far))


@pytest.mark.parametrize(
    ("obstacle", "move", "kind", "time", "point"),
    [
        ([(1, 1), (2, 1), (1, 2)], (0, 0), Kind.OBSTACLE_INSIDE, 0, (1, 1)),
        ([(-9, -9), (20, -9), (-9, 20)], (3, 3), Kind.ROBOT_INSIDE, 0, (0, 0)),
        (SQUARE, (1, 0), Kind.ROBOT_INSIDE, 0, (0, 0)),  # equal
        ([(-2, 1), (6, 1), (6, 3), (-2, 3)], (0, 9), Kind.OVERLAP, 0, (4, 1)),  # a cross
        ([(4, 0), (8, 0), (8, 4), (4, 4)], (-5, 0), Kind.EDGE_EDGE, 0, (4, 2)),  # leaves at once
        ([(4, 4), (8, 4), (8, 8)], (3, -3), Kind.CORNER_CORNER, 0, (4, 4)),
        ([(4, 4), (8, 4), (8, 8)], (0, 5), Kind.CORNER_CORNER, 0, (4, 4)),
        ([(9, 1), (12, 2), (12, 3)], (5, 0), Kind.EDGE_CORNER, 1, (9, 1)),  # at the very end
        ([(9, -5), (12, 0), (9, 5)], (6, 0), Kind.EDGE_EDGE, Fraction(5, 6), (9, 2)),
        ([(7, 4), (12, 4), (12, 9)], (4, 0), Kind.CORNER_CORNER, Fraction(3, 4), (7, 4)),
    ],
)
def test_degenerate_contacts(obstacle, move, kind, time, point):
    scenario = Scenario(SQUARE, move, [obstacle])
    check(scenario)
    found = decisive(scenario)
    assert (found.kind, found.time, found.point) == (kind, time, point)


def test_the_first_of_equals_is_named():
    beside = [(7, 0), (9, 0), (7, 4)]
    above = [(0, 7), (4, 7), (0, 9)]
    for obstacles in ([beside, above], [above, beside]):
        assert decisive(Scenario(SQUARE, (6, 6), obstacles)).obstacle == 0
        assert decisive(Scenario(SQUARE, (1, 1), obstacles)).obstacle == 0


def test_a_gap_of_one_lattice_line_at_the_coordinate_limit():
    robot = [(-LIMIT, -LIMIT), (1 - LIMIT, -LIMIT), (-LIMIT, 1 - LIMIT)]
    far = LIMIT, LIMIT
    check(Scenario(robot, (1, 0), [[(2 - LIMIT, 1 - LIMIT), far, (2 - LIMIT, LIMIT)]]))
    check(Scenario(robot, (2 * LIMIT - 1, 1), [[(1 - LIMIT, 3 - LIMIT), (0, 2 - LIMIT), far]]))
    touch = Scenario(robot, (2 * LIMIT - 1, 0), [[(LIMIT, -LIMIT), far, (1, 1)]])
    check(touch)
    assert decisive(touch).time == 1


def test_a_robot_of_many_corners_is_searched_not_walked(monkeypatch):
    round_robot = hull([(x, x * x) for x in range(-3000, 3000)])
    y = 2999 * 2999
    obstacles = [[(x, y), (x + 3, y), (x, y + 2)] for x in range(9000, 11_000, 7)]
    asked = []
    farthest = extremes.Extremes.farthest
    monkeypatch.setattr(extremes.Extremes, "farthest", lambda *a: asked.append(a) or farthest(*a))
    assert decisive(Scenario(round_robot, (0, -5), obstacles)).obstacle == 0
    assert len(asked) < 100  # their boxes exclude all but the first few
