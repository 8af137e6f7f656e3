"""What is said to be special in a small scenario."""

import pytest

from gen.scenario import parse
from pictures.special import MOST_FACTS, MOST_VERTICES, special_facts


def facts(text):
    (scenario,) = parse(f"1 {text}".encode())
    return special_facts(scenario)


@pytest.mark.parametrize(
    ("text", "fact"),
    [
        ("3 0 0 0 0 0 1 0 0 1", "there is no obstacle (k = 0)"),
        ("3 1 0 5 0 0 1 0 0 1 3 9 9 11 10 10 12", "the move is vertical (dx = 0)"),
        ("3 1 5 0 0 0 1 0 0 1 3 9 9 11 10 10 12", "the move is horizontal (dy = 0)"),
        (
            "3 1 2 2 0 0 2 1 1 1 3 9 9 11 10 10 12",
            "the robot's edge (1, 1)–(0, 0) is parallel to the move",
        ),
        (
            "3 1 0 0 0 0 2 1 1 2 3 2 1 4 0 5 4",
            "the robot only touches obstacle 1, corner on corner",
        ),
        (
            "3 1 0 0 1 1 2 1 1 2 3 0 0 9 0 0 9",
            "the robot begins wholly inside obstacle 1, so no edges cross there",
        ),
        (
            "3 1 0 0 0 0 9 0 0 9 3 1 1 2 1 1 2",
            "obstacle 1 is wholly inside the robot from the start, so no edges cross there",
        ),
        ("3 2 0 0 0 0 9 1 1 9 3 1 1 2 1 1 2 3 5 3 6 3 5 4", "the robot touches 2 obstacles"),
        (
            "4 1 9 0 0 0 1 0 1 3 0 3 3 5 1 6 1 5 2",
            "obstacle 1 lies wholly inside the swept area, and the robot touches it neither at "
            "the start nor at the end",
        ),
        (
            "4 1 0 0 0 1 9 1 9 2 0 2 4 4 0 5 0 5 9 4 9",
            "the robot and obstacle 1 cross, and no corner of either lies in the other",
        ),
        (
            "4 1 1 0 0 1 9 1 9 2 0 2 4 4 0 5 0 5 9 4 9",
            "the swept area and obstacle 1 cross, and no corner of either lies in the other",
        ),
        (
            "3 1 0 0 -1 0 1 1 0 1 3 0 -1 1 0 0 0",
            "no edge of obstacle 1 separates the two, "
            "but the edge (-1, 0)–(1, 1) of the robot does",
        ),
    ],
)
def test_a_fact_is_said(text, fact):
    assert facts(text)[0] == fact


def test_a_scene_in_which_nothing_meets_nor_is_in_line_is_not_special():
    assert facts("3 1 3 1 0 0 5 2 2 7 3 100 31 109 45 101 53") == ()


def test_corners_in_line_and_level_are_said_when_nothing_else_is():
    assert facts("3 1 0 0 0 0 4 0 1 5 4 7 0 12 -3 11 4 9 6") == (
        "the corner (7, 0) of obstacle 1 lies on the line through the edge (0, 0)–(4, 0) of the "
        "robot",
        "the corners (0, 0) of the robot and (7, 0) of obstacle 1 have the same y",
    )


def test_there_are_few_facts_and_none_about_a_large_scenario():
    square = "4 1 0 2 0 0 2 0 2 2 0 2 4 4 0 6 0 6 2 4 2"
    assert len(facts(square)) == MOST_FACTS
    many = " ".join(f"{x} {x * x}" for x in range(MOST_VERTICES))
    assert facts(f"{MOST_VERTICES} 1 0 0 {many} 3 50 0 51 0 50 1") == ()
