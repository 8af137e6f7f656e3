"""The geometry of the page, computed in the page, against the reference and other methods."""

from fractions import Fraction
from io import BytesIO
from itertools import pairwise

import pytest

from gen.families.registry import FAMILIES, find
from gen.geometry import apart, cross, hull, is_strictly_convex, minus, sweep, translated
from gen.rng import Rng
from gen.scenario import LIMIT, Scenario, into_corner, parse, render
from gen.validator import InputError, load_rules, validate
from judge.kit.paths import DATA, REFERENCE
from judge.kit.trusted import python_command, read_answers, run_trusted
from stress.chance import random_scenarios

SMALL_FILES = sorted(
    path for group in ("static", "small") for path in (DATA / "secret" / group).glob("*.in")
)
PRECISION = sorted(name for name, family in FAMILIES.items() if family.room == "precision")
RULES = load_rules()


def reference(content):
    count = int(content.split(b"\n", 1)[0])
    return read_answers(
        "solution.py", run_trusted("solution.py", python_command(REFERENCE), content), count
    )


def random_file(seed, count):
    """Return tiny random scenarios as a file; every fourth in a corner of the world."""
    rng = Rng(seed)
    return render(
        into_corner(rng, scenario) if index % 4 == 0 else scenario
        for index, scenario in enumerate(random_scenarios(seed, count))
    )


@pytest.mark.parametrize("scenarios", [2_000, pytest.param(6_000, marks=pytest.mark.slow)])
def test_random_scenarios_get_the_answers_of_the_reference(computed, scenarios):
    content = random_file(1, scenarios)
    found = computed("answers", content.decode())
    assert found == reference(content)
    assert scenarios < 4 * found.count("YES") < 3 * scenarios


@pytest.mark.parametrize("name", PRECISION)
def test_scenes_at_the_limit_of_precision_get_the_answers_of_the_reference(computed, name):
    content = render(find(name).scenarios({"scenarios": 60}, 1))
    assert computed("answers", content.decode()) == reference(content)


def test_every_small_file_of_the_data_gets_its_answers(computed):
    files = [*sorted((DATA / "sample").glob("*.in")), *SMALL_FILES]
    assert len(files) > 80
    scenarios = 0
    for file in files:
        found = computed("answers", file.read_text())
        assert found == file.with_suffix(".ans").read_text().split(), file.name
        scenarios += len(found)
    assert scenarios > 10_000


def random_polygons(seed, count):
    """Yield strictly convex polygons, small ones and others as wide as the world."""
    rng = Rng(seed)
    made = 0
    while made < count:
        size = rng.choice((3, 6, 40, LIMIT))
        points = [
            (rng.between(-size, size), rng.between(-size, size)) for _ in range(rng.between(3, 12))
        ]
        polygon = hull(points)
        if len(polygon) >= 3:
            made += 1
            yield polygon


def test_sums_are_the_hulls_of_all_sums_of_vertices(computed):
    polygons = list(random_polygons(2, 800))
    pairs = list(pairwise(polygons))
    for (a, b), found in zip(pairs, computed("sums", pairs), strict=True):
        vertices = [tuple(vertex) for vertex in found]
        lowest = min(range(len(vertices)), key=lambda i: vertices[i][::-1])
        assert lowest == 0
        expected = hull([(ax + bx, ay + by) for ax, ay in a for bx, by in b])
        at = expected.index(vertices[0])
        assert vertices == expected[at:] + expected[:at]


def first_contact(robot, move, obstacle):
    """Return the moment of the first contact by another method: corners that run into edges."""
    if not apart(robot, obstacle):
        return Fraction(0)
    dx, dy = move
    moments = [
        *_meetings(robot, obstacle, (dx, dy)),
        *_meetings(obstacle, robot, (-dx, -dy)),
    ]
    return min(moments, default=None)


def _meetings(corners, polygon, move):
    """Yield the moments in 0..1 at which moving corners lie on edges that they are not along."""
    for corner in corners:
        for start, end in pairwise([*polygon, polygon[0]]):
            edge = minus(end, start)
            rate = cross(edge, move)
            if rate == 0:
                continue
            moment = Fraction(cross(edge, minus(start, corner)), rate)
            place = (corner[0] + moment * move[0], corner[1] + moment * move[1])
            along = edge[0] * (place[0] - start[0]) + edge[1] * (place[1] - start[1])
            if 0 <= moment <= 1 and 0 <= along <= edge[0] ** 2 + edge[1] ** 2:
                yield moment


def test_first_contacts_are_those_of_corners_that_run_into_edges(computed):
    content = random_file(3, 800)
    contacts = computed("contacts", content.decode())
    kinds = set()
    for scenario, found in zip(parse(content), contacts, strict=True):
        for obstacle, contact in zip(scenario.obstacles, found, strict=True):
            expected = first_contact(scenario.robot, scenario.move, obstacle)
            assert (None if contact is None else Fraction(contact[0])) == expected
            touches = not apart(sweep(scenario.robot, scenario.move).vertices, obstacle)
            assert touches == (expected is not None)
            kinds.add(expected if expected in (None, 0, 1) else "between")
    assert kinds == {None, 0, 1, "between"}


def test_at_the_first_contact_only_boundary_points_are_shared_also_far_away(computed):
    rng = Rng(6)
    robot = [(-LIMIT, -LIMIT), (-LIMIT + 7, -LIMIT + 1), (-LIMIT + 3, -LIMIT + 8)]
    scenarios = []
    for _ in range(200):
        x, y = rng.between(-LIMIT // 2, LIMIT // 2), rng.between(-LIMIT // 2, LIMIT // 2)
        move = (
            x + LIMIT + rng.between(5_000_000, 8_000_000),
            y + LIMIT + rng.between(5_000_000, 8_000_000),
        )
        wide = 10**7
        obstacle = [(x + wide + 1, y), (x + wide, y + wide), (x, y + wide + 3)]
        scenarios.append(Scenario(robot, move, [obstacle]))
    found = computed("contacts", render(scenarios).decode())
    moments = set()
    for scenario, (contact,) in zip(scenarios, found, strict=True):
        expected = first_contact(scenario.robot, scenario.move, scenario.obstacles[0])
        assert (contact and Fraction(contact[0])) == expected
        assert contact is None or contact[1] == "boundary"
        moments.add(expected)
    assert sum(moment is not None and moment.denominator > 10**9 for moment in moments) > 50


def test_convexity_is_decided_as_in_the_kit(computed):
    rng = Rng(4)
    polygons = [
        [(rng.between(0, 3), rng.between(0, 3)) for _ in range(rng.between(3, 6))]
        for _ in range(3_000)
    ]
    expected = [is_strictly_convex(polygon) for polygon in polygons]
    assert computed("convex", polygons) == expected
    assert 50 < sum(expected) < 2_950
    wide = [[(0, 0), (LIMIT, 1), (2 * LIMIT - 1, 3)], [(0, 0), (LIMIT, 1), (2 * LIMIT, 2)]]
    assert computed("convex", wide) == [True, False]


def test_faults_are_named_as_by_the_validator(computed):
    files = sorted((DATA / "invalid_input").glob("*.in"))
    assert len(files) > 40
    contents = [file.read_bytes() for file in files]
    for numbers in ("9" * 18 + " 0", "0 -" + "9" * 17 + "1", "-" + "9" * 18 + " " + "9" * 18):
        contents.append(f"1\n3 0\n0 0\n{numbers}\n".encode())  # a Number would round them
        contents.append(f"1\n3 0\n{numbers}\n".encode())
        contents.append(f"1\n{numbers}\n".encode())
    for content, found in zip(contents, faults(computed, contents), strict=True):
        assert found == validator_says(content)


def faults(computed, contents):
    return computed("faults", [content.decode("latin-1") for content in contents])


def validator_says(content):
    try:
        validate(BytesIO(content), RULES)
    except InputError as fault:
        return {"line": fault.line, "reason": fault.reason}
    return None


def test_damaged_files_are_judged_as_by_the_validator(computed):
    rng = Rng(5)
    sample = (DATA / "sample" / "01-first.in").read_bytes()
    damaged = []
    for _ in range(800):
        at, kind = rng.below(len(sample)), rng.below(3)
        byte = rng.choice(b"0123456789- \n\r\t'\"\\x\x80\xff\x00")
        end = at if kind == 0 else at + 1
        damaged.append(sample[:at] + (b"" if kind == 2 else bytes([byte])) + sample[end:])
    found = faults(computed, [sample, *damaged])
    assert found == [validator_says(content) for content in (sample, *damaged)]
    assert 50 < found.count(None) < 750


def test_moves_to_the_very_limit(computed):
    robot = [(-LIMIT, -LIMIT), (-LIMIT + 1, -LIMIT), (-LIMIT, -LIMIT + 1)]
    obstacle = translated(robot, (LIMIT, LIMIT))
    for move, answer in (((2 * LIMIT - 1, 2 * LIMIT - 1), "NO"), ((2 * LIMIT - 1, 0), "YES")):
        text = f"1\n3 1\n{move[0]} {move[1]}\n"
        for polygon in (robot, obstacle):
            text += "3\n" if polygon is obstacle else ""
            text += "".join(f"{x} {y}\n" for x, y in polygon)
        assert computed("answers", text) == [answer]
