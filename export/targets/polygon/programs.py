"""The programs of a Polygon package: the validator, the checker, and how solutions are tagged."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, NamedTuple

from jinja2 import Environment, StrictUndefined

from export.package import Submission
from judge.kit.paths import REFERENCE
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict

HERE = Path(__file__).parent
# Polygon's names of its compilers. Its other C++ compilers make 32-bit programs.
CPP = "cpp.gcc13-64-winlibs-g++20"
LANGUAGES = {".cpp": CPP, ".java": "java21", ".py": "python.3"}
MAIN, REJECTED = "main", "rejected"
TAGS = {
    frozenset({Verdict.AC}): "accepted",
    frozenset({Verdict.WA}): "wrong-answer",
    frozenset({Verdict.TLE}): "time-limit-exceeded",
}


class CheckerTest(NamedTuple):
    """A test of the checker: two texts, and its verdict on them."""

    output: str
    answer: str
    verdict: str


CHECKER_TESTS = (
    CheckerTest("YES\nNO\n", "YES\nNO\n", "ok"),
    CheckerTest("  yes\tNo", "YES\nNO\n", "ok"),
    CheckerTest("\r\nYES\r\n\r\nNO\r\n", "YES\nNO\n", "ok"),
    CheckerTest("YES\nYES\n", "YES\nNO\n", "wrong-answer"),
    CheckerTest("YES\n", "YES\nNO\n", "wrong-answer"),
    CheckerTest("YES\nNO\nNO\n", "YES\nNO\n", "wrong-answer"),
    CheckerTest("YES\nnope\n", "YES\nNO\n", "wrong-answer"),
    CheckerTest("YESNO\n", "YES\nNO\n", "wrong-answer"),
    CheckerTest("", "YES\nNO\n", "wrong-answer"),
)


def rendered(template: str, **values: Any) -> str:
    """Return a template of this room with its values, which are not escaped: it is no HTML."""
    environment = Environment(undefined=StrictUndefined, keep_trailing_newline=True)
    environment.policies["json.dumps_function"] = lambda value, **_: json.dumps(value)
    text = (HERE / template).read_text(encoding="utf-8")
    return environment.from_string(text).render(**values)


def validator(problem: Problem) -> str:
    """Return the validator in C++ for testlib, with the constants of problem.toml."""
    return rendered("validator.cpp.jinja", problem=problem, bounds=problem.constraints)


def checker() -> Path:
    """Return the path of the checker in C++ for testlib."""
    return HERE / "check.cpp"


def tag(submission: Submission) -> str:
    """Return Polygon's word for the verdict over all tests.

    "rejected" permits any failure: Polygon has no word for a crash, or for "this or that".
    """
    if submission.path == REFERENCE:
        return MAIN
    return TAGS.get(submission.overall, REJECTED)
