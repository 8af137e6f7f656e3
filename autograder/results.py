"""The form of Gradescope's results.json, and what goes into it.

Source: https://gradescope-autograders.readthedocs.io/en/latest/specs/. A test case there is a
group here, as it scores all or nothing. Everything in it may be seen by the student; what only the
instructor should see is printed on standard output, which Gradescope hides from students.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Literal

import msgspec

from autograder.inline import without_stylesheet
from judge.kit.text import printable_name
from judge.problem.declaration import Group
from judge.problem.verdict import Verdict
from judge.reports import words
from judge.reports.html import MEANING
from judge.reports.page import render
from judge.reports.slowness import TITLE, slow_sentences
from judge.results import GroupResult, Judging

HERE = Path(__file__).parent
Form = Literal["text", "html", "simple_format", "md", "ansi"]
Visibility = Literal["hidden", "after_due_date", "after_published", "visible"]
Unset = msgspec.UnsetType
UNSET = msgspec.UNSET

REASON_CHARS = 2000
FAILED = (
    "The autograder failed, so your program has no score yet. This is not your program's fault: "
    "please tell your instructor."
)


class Test(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One entry of the list of tests. Without a score, it only passes or fails."""

    name: str
    status: Literal["passed", "failed"]
    output: str
    score: int | Unset = UNSET
    max_score: int | Unset = UNSET
    output_format: Form = "text"
    visibility: Visibility = "visible"


class Results(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The content of results.json. Without any score, Gradescope gives none."""

    output: str
    tests: list[Test]
    score: int | Unset = UNSET
    execution_time: float | Unset = UNSET
    output_format: Form = "html"
    visibility: Visibility = "visible"
    stdout_visibility: Visibility = "hidden"


def judged(judging: Judging, seconds: float) -> bytes:
    """Return results.json for a judging, as it may be told, which took so many seconds."""
    output = render(
        "results.html",
        HERE,
        judging=judging,
        meaning=MEANING[judging.verdict],
        failure=judging.first_failure,
        diagnosis=judging.diagnosis,
        example=judging.counterexample,
        without_stylesheet=without_stylesheet,
        headline=words.headline,
        missed_title=words.missed_title,
        wrong_scenes=words.wrong_scenes,
        like_sentence=words.like_sentence,
        size_of=words.size_of,
        limits_line=words.limits_line,
        slow_title=TITLE,
        slow=[] if judging.slowness is None else slow_sentences(judging.slowness),
    )
    return _text(
        Results(
            output=output,
            tests=[_test(group, judging) for group in judging.groups],
            score=judging.score,
            execution_time=round(seconds, 1),
        )
    )


def refused(reason: str, groups: Sequence[Group]) -> bytes:
    """Return results.json for something that is no submission: no points, and the reason."""
    why = printable_name(reason, REASON_CHARS)
    output = render("refused.html", HERE, reason=why)
    tests = [Test(each.name, "failed", f"not judged: {why}", 0, each.points) for each in groups]
    return _text(Results(output=output, tests=tests, score=0))


def broken(reason: str) -> bytes:
    """Return results.json for a failure of the judge: no score; the instructor sees the reason."""
    said = "\n".join(printable_name(line) for line in reason.splitlines())
    test = Test("autograder", "failed", said, visibility="hidden")
    return _text(Results(output=FAILED, tests=[test], output_format="text"))


def _test(group: GroupResult, judging: Judging) -> Test:
    passed = group.verdict is Verdict.AC and group.whole
    return Test(
        name=group.name,
        status="passed" if passed else "failed",
        output=_said(group, judging),
        score=group.score,
        max_score=group.max_score,
    )


def _said(group: GroupResult, judging: Judging) -> str:
    """Return the lines about one group: its verdict, where it failed, its slowest case."""
    if judging.verdict is Verdict.CE:
        return "CE: the program does not compile"
    lines = [f"{group.verdict}: {MEANING[group.verdict]} ({words.count_of(group)} cases were run)"]
    failed = next((r for r in group.cases if r.verdict not in (None, Verdict.AC)), None)
    if failed is not None:
        lines.append(f"first failure: {words.headline(failed)}")
        if failed.stderr and failed.verdict is Verdict.RTE:
            lines += ["standard error (the end):", *words.last_lines(failed.stderr)]
    if group.slowest is not None:
        lines.append(
            f"slowest case: {group.slowest.case.name}, {group.slowest.cpu_s:.2f} s of CPU time"
        )
    return "\n".join(lines)


def _text(results: Results) -> bytes:
    return msgspec.json.format(msgspec.json.encode(results), indent=2) + b"\n"
