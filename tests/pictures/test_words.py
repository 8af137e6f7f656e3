"""The sentence that says why."""

# ruff: noqa: E501 (whole sentences)

import doctest

import pytest

from gen.scenario import Scenario
from pictures import words
from pictures.words import sentence

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
START, END = "at the start of the move (t = 0)", "at the end of the move (t = 1)"


@pytest.mark.parametrize(
    ("move", "obstacles", "said"),
    [
        ((1, 1), [], "There are no obstacles, so the robot can touch nothing."),
        ((0, 0), [[(1, 1), (2, 1), (1, 2)]], "Obstacle 1 is inside the robot from the start."),
        ((9, 9), [[(-9, -9), (20, -9), (-9, 20)]], "The robot stands inside obstacle 1 from the start."),
        ((9, 9), [[(2, 2), (9, 1), (9, 3)]], "The corner (2, 2) of obstacle 1 is inside the robot from the start."),
        ((9, 9), [[(3, -9), (9, -9), (3, 9)]], "The robot's corner (4, 0) is inside obstacle 1 from the start."),
        ((0, 0), [[(-2, 1), (6, 1), (6, 3), (-2, 3)]],
         "The robot's edge (4, 0)–(4, 4) crosses the edge (-2, 1)–(6, 1) of obstacle 1 from the start, at (4, 1)."),
        ((0, 0), [[(4, 4), (9, 4), (9, 9)]],
         "The robot does not move, and its corner (4, 4) touches the corner (4, 4) of obstacle 1."),
        ((6, 0), [[(50, 0), (51, 0), (50, 1)], [(7, -9), (9, -9), (9, 9), (7, 9)]],
         "At t = 1/2 of the move, the robot's edge that started at (4, 0)–(4, 4) touches the edge (7, 9)–(7, -9) of obstacle 2, all along from (7, 0) to (7, 4)."),
        ((0, 0), [SQUARE], "The robot stands exactly where obstacle 1 is, from the start."),
        ((3, 0), [[(7, 4), (9, 4), (9, 9)]],
         "At the end of the move (t = 1), the robot's corner that started at (4, 4) touches the corner (7, 4) of obstacle 1."),
        ((1, 1), [[(7, 6), (9, 6), (9, 9)]],
         f"No contact: the robot comes closest to obstacle 1 {END}, where its corner (4, 4), then at (5, 5), is √5 ≈ 2.24 from the corner (7, 6)."),
        ((-1, 0), [[(6, 1), (9, 1), (9, 9)]],
         f"No contact: the robot comes closest to obstacle 1 {START}, where its edge (4, 0)–(4, 4) is 2 from the corner (6, 1)."),
        ((0, 0), [[(6, 1), (9, 1), (9, 9)], [(5, 1), (9, 1), (9, 9)]],
         "No contact: obstacle 2 is nearest, and the robot's edge (4, 0)–(4, 4) is 1 from the corner (5, 1) of obstacle 2."),
    ],
)  # fmt: skip
def test_sentences(move, obstacles, said):
    assert sentence(Scenario(SQUARE, move, obstacles)) == said


def test_examples():
    assert doctest.testmod(words).failed == 0
    assert doctest.testmod(words).attempted == 5
