"""Mutants: what is changed, what is not, and how a mutant is known again."""

import pytest

from judge.kit.paths import ROOT
from strength.mutants.mutate import mutants

PROGRAM = b'''"""Less < more."""
import sys


def least(numbers: list[int] = [1]) -> int:
    """Return x < y."""
    low = numbers[0]
    for x in numbers[1:]:
        if x < low and not x == 7:
            low = x
    return -low


if __name__ == "__main__":
    print(least([1, 2]))
'''


def changes(program):
    return {(m.line, m.mutated) for m in mutants("p.py", program)}


def test_each_kind_of_change():
    found = changes(PROGRAM)
    test = "if x < low and not x == 7:"
    for mutated in (
        "if x <= low and not x == 7:",
        "if x > low and not x == 7:",
        "if x < low or not x == 7:",
        "if x < low and not not x == 7:",
        "if x < low and not x != 7:",
        "if x < low and not x == 8:",
        "if x < low and not x == 6:",
        "if True:",
        "if False:",
    ):
        assert (test, mutated) in found
    loop = "for x in numbers[1:]:"
    for mutated in ("for x in ():", "for x in numbers[2:]:", "for x in numbers[:]:"):
        assert (loop, mutated) in found
    assert ("low = numbers[0]", "pass") in found
    assert ("low = numbers[0]", "low = numbers[1]") in found
    assert ("return -low", "return low") in found
    assert ("return -low", "pass") in found


def test_what_decides_no_answer_stays():
    lines = {line for line, _ in changes(PROGRAM)}
    assert not any("Less" in line or "Return" in line or "__main__" in line for line in lines)
    # Of the signature only the default may change, never the annotations.
    signature = {m for line, m in changes(PROGRAM) if line.startswith("def")}
    assert signature == {
        "def least(numbers: list[int] = [2]) -> int:",
        "def least(numbers: list[int] = [0]) -> int:",
    }


def test_no_two_are_the_same_and_none_is_the_original():
    sources = [m.source for m in mutants("p.py", PROGRAM)]
    assert len(set(sources)) == len(sources)
    assert PROGRAM not in sources


def test_equal_changes_of_equal_lines_are_counted():
    twice = b"def f(x):\n    x = x + 1\n    x = x + 1\n"
    found = [m.nth for m in mutants("p.py", twice) if m.mutated == "x = x - 1"]
    assert found == [1, 2]


def test_identities_do_not_move_with_the_lines():
    moved = PROGRAM.replace(b"import sys", b"import sys\n\nHELLO = sys")
    before = {m.identity for m in mutants("p.py", PROGRAM)}
    after = {m.identity for m in mutants("p.py", moved) if m.line != "HELLO = sys"}
    assert before == after


@pytest.mark.parametrize("name", ["solution.py", "submissions/accepted/textbook.py"])
def test_mutants_of_the_real_programs_are_programs(name):
    found = mutants(name, (ROOT / name).read_bytes())
    assert len(found) > 150
    for mutant in found:
        compile(mutant.source, str(mutant), "exec")
