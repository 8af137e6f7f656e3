"""The report as one HTML page that needs nothing else: `checker.py --html FILE`."""

from __future__ import annotations

import base64
from collections import Counter

from judge.kit.text import counted
from judge.problem.verdict import Verdict
from judge.reports import words
from judge.reports.page import render
from judge.reports.slowness import TITLE, slow_sentences
from judge.results import CaseResult, GroupResult, Judging

MEANING = {
    Verdict.AC: "accepted",
    Verdict.WA: "wrong answer",
    Verdict.TLE: "time limit exceeded",
    Verdict.RTE: "run-time error",
    Verdict.MLE: "memory limit exceeded",
    Verdict.OLE: "output limit exceeded",
    Verdict.CE: "compile error",
    Verdict.JE: "judge error",
}


def to_html(judging: Judging) -> bytes:
    """Return the report as a page."""
    failure, example = judging.first_failure, judging.counterexample

    def share(result: CaseResult) -> float:
        return min(100.0, 100.0 * result.cpu_s / judging.time_limit_s)

    page = render(
        "judging.html",
        judging=judging,
        groups=judging.groups,
        failure=failure,
        scenario=None if failure is None else words.failing_scenario(failure),
        short=words.SHORT_LINES,
        diagnosis=judging.diagnosis,
        example=example,
        as_image=_as_image,
        slow_title=TITLE,
        slow=[] if judging.slowness is None else slow_sentences(judging.slowness),
        first_of=words.first_of,
        meaning=MEANING,
        share=share,
        note_of=_note,
        count_of=words.count_of,
        not_run=_not_run,
        as_input=words.as_input,
        shown=words.shown,
        see_it=words.see_it,
        missed_title=words.missed_title,
        wrong_scenes=words.wrong_scenes,
        like_sentence=words.like_sentence,
        size_of=words.size_of,
        limits_line=words.limits_line,
        wall_line=words.wall_line,
        changed_line=words.changed_line,
    )
    return page.encode()


def _as_image(picture: str) -> str:
    """Return a picture as a data URL: in an image, its styles and names stay its own."""
    return "data:image/svg+xml;base64," + base64.b64encode(picture.encode()).decode()


def _note(result: CaseResult) -> str:
    """Return what is said about a case besides its figures."""
    message = result.message.partition("\n")[0]
    if not result.retried:
        return message
    first = f", {result.first_verdict} at first" if result.first_verdict else ""
    return f"{message} (repeated{first})".strip()


def _not_run(group: GroupResult) -> list[tuple[str, str]]:
    """Return why cases were not run, and how many, as words."""
    reasons = Counter(result.message for result in group.cases if result.verdict is None)
    return [(reason, counted(number, "case")) for reason, number in reasons.items()]
