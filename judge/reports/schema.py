"""The JSON report. The types below define its schema.

`make schema` writes docs/report.schema.json. Each version keeps all keys of the one before and
adds some: a reader of an earlier version can read it if it skips unknown keys.
"""

from __future__ import annotations

from typing import Annotated

import msgspec

from judge.explanation import Counterexample, Diagnosis, Slowness
from judge.kit.files import write_whole
from judge.kit.paths import ROOT
from judge.kit.text import printable_name
from judge.problem.verdict import Verdict
from judge.results import CaseResult, Judging

SCHEMA_VERSION = 4
FILE = ROOT / "docs" / "report.schema.json"


Seconds = Annotated[float, msgspec.Meta(ge=0)]
Mebibytes = Annotated[float, msgspec.Meta(ge=0)]
Points = Annotated[int, msgspec.Meta(ge=0)]


class MismatchReport(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The first difference between an output and the answer; new in version 2.

    scenario: number of the answer, from 1. line, column: its place in the output, from 1; for
    a missing answer, the end of the output. expected null: the output has too many answers;
    found null: it has too few.
    """

    scenario: int
    line: int
    column: int
    expected: str | None
    found: str | None


class CaseReport(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One test case, in the order of judging; verdict null: not run, and message says why.

    wall_s: elapsed seconds. retried: repeated, as this machine is slower than the declared
    limit assumes; first_verdict: of the first run, if it differs. mismatch: for WA, new in
    version 2. New in version 3: stderr, what is kept of the standard error of a program that is
    not accepted; withheld: problem.toml does not permit to name the case, so that `case` is only
    its number in the group, and message, mismatch and stderr of a WA or RTE are empty.
    """

    case: str
    group: str
    verdict: Verdict | None
    cpu_s: Seconds
    wall_s: Seconds
    memory_mib: Mebibytes
    message: str
    retried: bool
    first_verdict: Verdict | None
    mismatch: MismatchReport | None
    stderr: str
    withheld: bool


class GroupReport(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One group; score is max_score or 0."""

    name: str
    verdict: Verdict
    score: Points
    max_score: Points


class LessonReport(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A lesson that the program misses, and the gallery's scenarios that it answers wrongly."""

    id: str
    sentence: str
    scenarios: list[str]


class DiagnosisReport(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What a run on the gallery of tiny scenarios says; new in version 3.

    lessons: those it misses, most telling first. remark: one sentence more, may be empty.
    scenarios, wrong: how many the gallery holds, and how many are answered wrongly.
    """

    lessons: list[LessonReport]
    remark: str
    scenarios: int
    wrong: int


class LikeReport(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A submission of the kit that answers the whole gallery exactly alike; new in version 3.

    submission: its path in submissions/. bug: completes `a program that ...`.
    """

    submission: str
    bug: str


class CounterexampleReport(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A smallest input that the program gets wrong; new in version 3.

    input: the whole text. expected, found: of its last scenario; found says in words how the
    program ended, if it did not answer. scenarios: more than 1 if the last answer depends on
    the earlier scenarios. obstacles, vertices: of the last scenario. sentence: why the
    expected answer is right. file: where the input is kept. seconds: the search took. steps:
    remarks on the search.
    """

    input: str
    expected: str
    found: str
    scenarios: int
    obstacles: int
    vertices: int
    sentence: str
    file: str | None
    seconds: Seconds
    steps: list[str]


class SizeReport(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How large the first test case is that the program was too slow for; new in version 4.

    family: what made it, may be empty. promise: of its group. robot, obstacles, obstacle: the
    largest m, k and n of its scenarios. walks: the sum of k * m. pairs: the sum of m * n.
    """

    case: str
    family: str
    promise: str
    scenarios: int
    robot: int
    obstacles: int
    obstacle: int
    walks: int
    pairs: int


class GrowthReport(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How the CPU time grows with one quantity N of the input; new in version 4.

    ladder: a short name. quantity: completes `N is ...`. sizes, cpu_s: the measured N and
    seconds, without the program's start. over: the first N that took too long, or null.
    exponent: b of the curve a * N ** b that fits, null without a fit; may: the one to aim at;
    too_fast: it is clearly larger than that.
    """

    ladder: str
    quantity: str
    sizes: list[int]
    cpu_s: list[Seconds]
    over: int | None
    exponent: float | None
    may: float
    too_fast: bool


class SlownessReport(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What is known about a program that was too slow; new in version 4.

    size: null if it may not be told, or the case is no input of this problem. growths: what
    grows too fast comes first; empty if nothing was measured.
    """

    size: SizeReport | None
    growths: list[GrowthReport]


class Report(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A whole judging.

    scale: how many times slower this machine is than the calibrating one, null if it was not
    needed, not measurable, or the limit was given; scale_source: where that figure comes
    from, new in version 2. wall: the wall around every run, null for none. partial: not all
    test cases of the kit were chosen; only groups judged whole score. New in version 3:
    diagnosis, like, counterexample; each is null if there is none or it may not be told;
    unexplained: why a search for a counterexample found none. New in version 4: slowness, null
    if no case was TLE or it may not be told.
    """

    schema_version: int
    submission: str
    language: str
    verdict: Verdict
    score: Points
    max_score: Points
    partial: bool
    message: str
    time_limit_s: Seconds
    declared_time_limit_s: Seconds
    memory_limit_mib: int
    scale: float | None
    scale_source: str | None
    wall: str | None
    groups: list[GroupReport]
    cases: list[CaseReport]
    diagnosis: DiagnosisReport | None
    like: LikeReport | None
    counterexample: CounterexampleReport | None
    unexplained: str
    slowness: SlownessReport | None


def report_of(judging: Judging) -> Report:
    """Return the report of a judging."""
    return Report(
        schema_version=SCHEMA_VERSION,
        submission=judging.submission,
        language=judging.language,
        verdict=judging.verdict,
        score=judging.score,
        max_score=judging.max_score,
        partial=judging.partial,
        message=judging.message,
        time_limit_s=judging.time_limit_s,
        declared_time_limit_s=judging.declared_s,
        memory_limit_mib=judging.memory_mib,
        scale=None if judging.scale is None else judging.scale.factor,
        scale_source=None if judging.scale is None else judging.scale.source,
        wall=judging.wall,
        groups=[GroupReport(g.name, g.verdict, g.score, g.max_score) for g in judging.groups],
        cases=[_case(result) for result in judging.cases],
        diagnosis=_diagnosis(judging.diagnosis),
        like=_like(judging.diagnosis),
        counterexample=_counterexample(judging.counterexample),
        unexplained=judging.unexplained,
        slowness=_slowness(judging.slowness),
    )


def _case(result: CaseResult) -> CaseReport:
    return CaseReport(
        case=result.case.name,
        group=result.case.group,
        verdict=result.verdict,
        cpu_s=result.cpu_s,
        wall_s=result.elapsed_s,
        memory_mib=result.memory_mib,
        message=result.message,
        retried=result.retried,
        first_verdict=result.first_verdict,
        mismatch=_mismatch(result),
        stderr=result.stderr,
        withheld=result.withheld,
    )


def _mismatch(result: CaseResult) -> MismatchReport | None:
    found = result.mismatch
    if found is None:
        return None
    return MismatchReport(found.scenario, found.line, found.column, found.expected, found.found)


def _diagnosis(found: Diagnosis | None) -> DiagnosisReport | None:
    if found is None:
        return None
    lessons = [LessonReport(each.id, each.sentence, list(each.scenes)) for each in found.lessons]
    return DiagnosisReport(lessons, found.remark, found.scenes, found.wrong)


def _like(found: Diagnosis | None) -> LikeReport | None:
    if found is None or found.like is None:
        return None
    return LikeReport(found.like.submission, found.like.bug)


def _counterexample(found: Counterexample | None) -> CounterexampleReport | None:
    if found is None:
        return None
    return CounterexampleReport(
        input=found.input,
        expected=found.expected,
        found=found.found,
        scenarios=found.scenarios,
        obstacles=found.obstacles,
        vertices=found.vertices,
        sentence=found.sentence,
        file=None if found.file is None else printable_name(str(found.file)),
        seconds=found.seconds,
        steps=list(found.steps),
    )


def _slowness(found: Slowness | None) -> SlownessReport | None:
    if found is None:
        return None
    size = (
        None
        if found.size is None
        else msgspec.convert(found.size, SizeReport, from_attributes=True)
    )
    return SlownessReport(
        size, [msgspec.convert(g, GrowthReport, from_attributes=True) for g in found.growths]
    )


def to_json(judging: Judging) -> bytes:
    """Return the report as JSON text."""
    return msgspec.json.format(msgspec.json.encode(report_of(judging)), indent=2) + b"\n"


def json_schema() -> bytes:
    """Return the JSON Schema (draft 2020-12) of a report: `docs/report.schema.json`."""
    schema = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": f"Report of a judging, version {SCHEMA_VERSION}",
        **msgspec.json.schema(Report),
    }
    text = msgspec.json.format(msgspec.json.encode(schema), indent=2) + b"\n"
    return text.replace(b"\\n    ", b"\\n")  # removes the indentation of docstrings


if __name__ == "__main__":
    write_whole(FILE, json_schema())
