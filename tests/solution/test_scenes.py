"""The reference, the brute force and the textbook method on scenes decided by hand."""

import subprocess
import sys

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gen.geometry import hull, translated
from gen.scenario import Scenario, render
from judge.kit.paths import ROOT

SOLVERS = ["solution.py", "brute.py", "submissions/accepted/textbook.py"]
E8 = 10**8

SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
TRIANGLE = [(0, 0), (4, 1), (1, 3)]
DIAMOND = [(0, -2), (2, 0), (0, 2), (-2, 0)]
BAR = [(10, -50), (11, -50), (11, 50), (10, 50)]
ROOM = [(-30, -30), (30, -30), (30, 30), (-30, 30)]

SCENES = [
    # what it is, robot, displacement, obstacles, answer
    ("no obstacles", TRIANGLE, (5, 7), [], "YES"),
    ("no obstacles, no move", TRIANGLE, (0, 0), [], "YES"),
    ("far away", SQUARE, (1, 1), [translated(SQUARE, (90, 90))], "YES"),
    ("vertex on vertex at the start", SQUARE, (-5, -5), [translated(SQUARE, (2, 2))], "NO"),
    ("vertex on vertex at the end", SQUARE, (5, 5), [translated(SQUARE, (7, 7))], "NO"),
    ("one short of the end", SQUARE, (4, 4), [translated(SQUARE, (7, 7))], "YES"),
    ("edge along edge, not moving", SQUARE, (0, 0), [translated(SQUARE, (2, 1))], "NO"),
    ("edge along edge, slid past", SQUARE, (90, 0), [translated(SQUARE, (40, 2))], "NO"),
    ("one unit beside", SQUARE, (90, 0), [translated(SQUARE, (40, 3))], "YES"),
    ("edges on one line, apart", SQUARE, (0, 0), [translated(SQUARE, (3, 0))], "YES"),
    ("vertex on edge in the middle", SQUARE, (9, 0), [[(5, 2), (9, 9), (4, 8)]], "NO"),
    ("met by the sweep only", SQUARE, (40, 0), [translated(SQUARE, (20, 1))], "NO"),
    ("behind", SQUARE, (40, 0), [translated(SQUARE, (-3, 0))], "YES"),
    ("touched behind", SQUARE, (40, 0), [translated(SQUARE, (-2, 0))], "NO"),
    ("robot inside an obstacle", SQUARE, (1, 1), [ROOM], "NO"),
    ("robot inside, leaving", SQUARE, (99, 0), [ROOM], "NO"),
    ("obstacle inside the robot", ROOM, (0, 0), [SQUARE], "NO"),
    ("obstacle inside the sweep only", ROOM, (400, 0), [translated(SQUARE, (200, 0))], "NO"),
    ("equal polygons", TRIANGLE, (0, 0), [TRIANGLE], "NO"),
    ("through a bar", SQUARE, (40, 0), [BAR], "NO"),
    ("up to a bar", SQUARE, (8, 0), [BAR], "NO"),
    ("nearly up to a bar", SQUARE, (7, 0), [BAR], "YES"),
    ("along a bar", SQUARE, (7, 300), [BAR], "YES"),
    ("straight up into it", SQUARE, (0, 8), [translated(SQUARE, (1, 9))], "NO"),
    ("straight up, stopped", SQUARE, (0, 6), [translated(SQUARE, (1, 9))], "YES"),
    ("straight down into it", SQUARE, (0, -9), [translated(SQUARE, (1, -9))], "NO"),
    ("straight down, stopped", SQUARE, (0, -6), [translated(SQUARE, (1, -9))], "YES"),
    ("diamonds tip to tip", DIAMOND, (10, 0), [translated(DIAMOND, (14, 0))], "NO"),
    ("diamonds past each other", DIAMOND, (20, 20), [translated(DIAMOND, (14, 4))], "YES"),
    ("diamonds edge along edge", DIAMOND, (20, 20), [translated(DIAMOND, (12, 8))], "NO"),
    ("boxes meet, diamonds do not", DIAMOND, (0, 0), [translated(DIAMOND, (3, 3))], "YES"),
    (
        "move along a robot's edge",
        TRIANGLE,
        (40, 10),
        [[(20, 4), (20, -9), (30, -9)]],
        "YES",
    ),
    (
        "move along a robot's edge, touching",
        TRIANGLE,
        (40, 10),
        [[(20, 5), (20, -9), (30, -9)]],
        "NO",
    ),
    ("only the last one is hit", SQUARE, (40, 0), [[*ROOM[:1], (-9, -30), (-9, -9)], BAR], "NO"),
    (
        "missed by one at the limit",
        [(-E8, -E8), (-E8 + 1, -E8), (-E8, -E8 + 1)],
        (2 * E8 - 1, 2 * E8 - 1),
        [[(E8, E8 - 1), (E8, E8), (E8 - 1, E8)], [(2 - E8, -E8), (E8, -E8), (E8, E8 - 2)]],
        "NO",
    ),
    (
        "the same, past the near triangle",
        [(-E8, -E8), (-E8 + 1, -E8), (-E8, -E8 + 1)],
        (2 * E8 - 1, 2 * E8 - 1),
        [[(2 - E8, -E8), (E8, -E8), (E8, E8 - 2)]],
        "YES",
    ),
]


def answers(solver, scenarios):
    done = subprocess.run(
        [sys.executable, ROOT / solver], input=render(scenarios), capture_output=True, check=True
    )
    return done.stdout.decode().split("\n")[:-1]


def disguises(scenario):
    """Yield the same question, mirrored and reversed, with other first vertices."""
    robot, (dx, dy), obstacles = scenario.robot, scenario.move, scenario.obstacles
    for turn, (sx, sy, swap) in enumerate(
        (sx, sy, swap) for sx in (1, -1) for sy in (1, -1) for swap in (False, True)
    ):

        def image(polygon, sx=sx, sy=sy, swap=swap, turn=turn):
            points = [(sy * y, sx * x) if swap else (sx * x, sy * y) for x, y in polygon]
            if (sx * sy < 0) != swap:
                points.reverse()
            turn %= len(points)
            return points[turn:] + points[:turn]

        move = (sy * dy, sx * dx) if swap else (sx * dx, sy * dy)
        yield Scenario(image(robot), move, [image(obstacle) for obstacle in obstacles])
        # The move back touches the same obstacles.
        back = (-move[0], -move[1])
        yield Scenario(translated(image(robot), move), back, [image(o) for o in obstacles])


@pytest.mark.parametrize("solver", SOLVERS)
def test_scenes_decided_by_hand(solver):
    scenarios, expected, names = [], [], []
    for name, robot, move, obstacles, answer in SCENES:
        for number, scenario in enumerate(disguises(Scenario(robot, move, obstacles))):
            scenarios.append(scenario)
            expected.append(answer)
            names.append(f"{name}, disguise {number}")
    found = answers(solver, scenarios)
    wrong = [n for n, e, f in zip(names, expected, found, strict=True) if e != f]
    assert not wrong


@st.composite
def wide_polygons(draw):
    """Strictly convex polygons anywhere in the upper range of the coordinates."""
    coordinate = st.one_of(st.integers(-E8, E8), st.sampled_from([-E8, E8, 0, E8 - 1, 1 - E8]))
    points = draw(st.lists(st.tuples(coordinate, coordinate), min_size=3, max_size=12))
    polygon = hull(points)
    return polygon if len(polygon) >= 3 else [(-E8, -E8), (E8, -E8), (E8, E8)]


@st.composite
def wide_scenarios(draw):
    robot = draw(wide_polygons())
    xs, ys = [x for x, _ in robot], [y for _, y in robot]
    move = (
        draw(st.integers(-E8 - min(xs), E8 - max(xs))),
        draw(st.integers(-E8 - min(ys), E8 - max(ys))),
    )
    return Scenario(robot, move, draw(st.lists(wide_polygons(), max_size=2)))


@settings(max_examples=15, deadline=None)
@given(st.lists(wide_scenarios(), min_size=1, max_size=40))
def test_solvers_agree_at_the_largest_coordinates(scenarios):
    assert len({tuple(answers(solver, scenarios)) for solver in SOLVERS}) == 1
