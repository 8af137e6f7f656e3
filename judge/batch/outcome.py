"""The outcome of judging one program: plain data that the store and other processes can hold."""

from __future__ import annotations

import msgspec

from judge.problem.verdict import Verdict
from judge.reports.words import headline
from judge.results import Judging


class GroupOutcome(msgspec.Struct, frozen=True):
    """One group: its verdict, and its points; max_score 0 for `sample`."""

    name: str
    verdict: Verdict
    score: int
    max_score: int


class Outcome(msgspec.Struct, frozen=True):
    """What a class report says about one program, after `[feedback]` of problem.toml.

    cpu_s: of the slowest case. partial: not all of the kit's cases were chosen. failure: the
    first failure, or what the compiler says, or why there is a judge error. lessons: the ids of
    those that it misses, most telling first. like: the submission of the kit that answers the
    whole gallery alike, or ""; bug: what that does wrong, completes `a program that ...`. remark:
    what else the diagnosis says. scale: of the machine, None if none was used. wall: None for
    none.
    """

    verdict: Verdict
    score: int
    max_score: int
    groups: list[GroupOutcome]
    cpu_s: float
    partial: bool = False
    failure: str = ""
    lessons: list[str] = []
    like: str = ""
    bug: str = ""
    remark: str = ""
    scale: float | None = None
    wall: str | None = None


def outcome_of(judging: Judging) -> Outcome:
    """Return the outcome of a judging. What may not be told must already be taken out of it."""
    failure, found = judging.first_failure, judging.diagnosis
    return Outcome(
        verdict=judging.verdict,
        score=judging.score,
        max_score=judging.max_score,
        groups=[GroupOutcome(g.name, g.verdict, g.score, g.max_score) for g in judging.groups],
        cpu_s=max((result.cpu_s for result in judging.cases), default=0.0),
        partial=judging.partial,
        failure=judging.message if failure is None else headline(failure),
        lessons=[] if found is None else [lesson.id for lesson in found.lessons],
        like="" if found is None or found.like is None else found.like.submission,
        bug="" if found is None or found.like is None else found.like.bug,
        remark="" if found is None else found.remark,
        scale=None if judging.scale is None else judging.scale.factor,
        wall=judging.wall,
    )


def judge_error(why: str, max_score: int) -> Outcome:
    """Return the outcome of a program that could not be judged for a fault that is not its own."""
    return Outcome(Verdict.JE, 0, max_score, [], 0.0, failure=why)
