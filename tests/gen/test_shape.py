"""The shape of the planned set: sizes at the limits, answers no guess hits, no file twice.

Cases that users added do not count: they may be one-sided, or like one another.
"""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from gen.plan import load_plan
from gen.scenario import parse
from gen.validator import load_rules
from judge.kit.paths import DATA
from judge.problem.declaration import load
from judge.problem.manifest import Entry, load_manifest

PROBLEM = load()
RULES = load_rules()
MANIFEST = load_manifest(DATA).cases
PLANNED = [recipe for recipe in load_plan() if recipe.case_name in MANIFEST]
ENTRIES = {recipe.case_name: MANIFEST[recipe.case_name] for recipe in PLANNED}
SCORED = [group.name for group in PROBLEM.groups if group.points]
COMMITTED = ["static", "small"]


def entries(group: str) -> list[Entry]:
    """Return the entries of the planned cases of a group."""
    return [ENTRIES[recipe.case_name] for recipe in PLANNED if recipe.group == group]


def inputs(group: str) -> list[Path]:
    found = [DATA / f"{recipe.case_name}.in" for recipe in PLANNED if recipe.group == group]
    if not all(path.exists() for path in found):
        pytest.skip(f"secret/{group} is not built; 'make data' builds it")
    return found


@pytest.mark.parametrize("group", SCORED)
def test_every_group_has_a_file_as_large_as_it_permits(group: str) -> None:
    rules = load_rules(group)
    assert max(entry.vertices for entry in entries(group)) == rules.max_vertices
    if rules.max_pair_sum is not None:
        assert max(entry.pair_sum for entry in entries(group)) == rules.max_pair_sum


def test_as_many_scenarios_as_permitted() -> None:
    assert max(entry.scenarios for entry in entries("large")) == RULES.max_scenarios


def test_the_largest_robot_and_the_most_obstacles_that_fit() -> None:
    heads = [_first_head(path) for path in inputs("large")]
    least = RULES.min_polygon_vertices
    # The robot leaves room for one triangle; the obstacles are triangles, as the robot is.
    assert max(m for m, _ in heads) == RULES.max_vertices - least
    assert max(k for _, k in heads) == (RULES.max_vertices - least) // least


def _first_head(path: Path) -> tuple[int, int]:
    """Return m and k of a file's first scenario."""
    with path.open() as file:
        file.readline()
        m, k = file.readline().split()
    return int(m), int(k)


@pytest.mark.parametrize("group", COMMITTED)
def test_coordinates_reach_the_limit_at_start_and_at_end_on_each_side(group: str) -> None:
    most = RULES.max_coordinate
    start: set[tuple[int, int]] = set()
    end: set[tuple[int, int]] = set()
    obstacles: set[tuple[int, int]] = set()
    for path in inputs(group):
        for scenario in parse(path.read_bytes()):
            for shown, polygons, move in (
                (start, [scenario.robot], (0, 0)),
                (end, [scenario.robot], scenario.move),
                (obstacles, scenario.obstacles, (0, 0)),
            ):
                for x, y in (vertex for polygon in polygons for vertex in polygon):
                    at = x + move[0], y + move[1]
                    shown |= {(axis, at[axis]) for axis in (0, 1) if abs(at[axis]) == most}
    sides = {(axis, sign * most) for axis in (0, 1) for sign in (1, -1)}
    assert (start, end, obstacles) == (sides, sides, sides)


@pytest.mark.parametrize("group", SCORED)
def test_no_guess_passes_a_group(group: str) -> None:
    yes = sum(entry.yes for entry in entries(group))
    no = sum(entry.no for entry in entries(group))
    assert 1 / 3 <= yes / no <= 3
    # The luckiest guesser says YES as often as it is right.
    total = yes + no
    log10_chance = yes * math.log10(yes / total) + no * math.log10(no / total)
    assert log10_chance < -9


@pytest.mark.parametrize("group", SCORED)
def test_no_constant_answer_passes_more_than_a_third_of_the_files(group: str) -> None:
    own = entries(group)
    for constant in ("no", "yes"):
        passed = [entry for entry in own if getattr(entry, constant) == 0]
        assert len(passed) <= len(own) / 3


def test_no_file_twice() -> None:
    sums = [entry.input.sha256 for entry in ENTRIES.values()]
    assert len(set(sums)) == len(sums)
