"""Trials: every way in which a program can fail, and that it can pass."""

import time

import pytest

from judge.problem.cases import Case
from judge.problem.verdict import Verdict
from strength.mutants.trial import Kill, first_kill

ECHO = b"import sys\nprint(sys.stdin.read())\n"


@pytest.fixture
def cases(tmp_path):
    made = []
    for name, text in (("a", "YES\n"), ("b", "NO\n")):
        (tmp_path / f"{name}.in").write_text(text)
        (tmp_path / f"{name}.ans").write_text(text)
        made.append(Case(name, ".", tmp_path / f"{name}.in", tmp_path / f"{name}.ans"))
    return made


def test_a_right_program_passes(cases):
    assert first_kill(ECHO, cases, 5, 512) is None
    assert first_kill(ECHO + b"sys.exit(0)", cases, 5, 512) is None


def test_white_space_and_case_do_not_matter(cases):
    assert first_kill(b"print('  yes' if input() == 'YES' else 'no')", cases, 5, 512) is None


@pytest.mark.parametrize(
    ("source", "case", "verdict"),
    [
        (b"print('YES')", "b", Verdict.WA),
        (b"print('NO')", "a", Verdict.WA),
        (b"pass", "a", Verdict.WA),
        (ECHO + b"1 // 0", "a", Verdict.RTE),
        (ECHO + b"sys.exit(3)", "a", Verdict.RTE),
        (b"x = [0]\nwhile True: x += x", "a", Verdict.RTE),
        (b"import os\nos._exit(0)", "a", Verdict.RTE),
        (b"while True: pass", "a", Verdict.TLE),
        (b"x = input()\nprint(x)\nwhile x == 'NO': pass", "b", Verdict.TLE),
        (b"9 ** 9 ** 9 ** 9", "a", Verdict.TLE),
        (b"print(", "a", Verdict.CE),
    ],
)
def test_the_first_case_that_fails_and_how(cases, source, case, verdict):
    assert first_kill(source, cases, 0.3, 256) == Kill(case, verdict)


def test_the_time_limit_is_of_each_case(cases):
    # Each case takes most of the limit: together they are over it.
    slow = ECHO + b"import time\nend = time.process_time() + 0.3\n"
    slow += b"while time.process_time() < end: pass\n"
    start = time.process_time()
    assert first_kill(slow, cases, 0.5, 512) is None
    assert time.process_time() - start < 0.3  # the child's time, not this process's
