"""The JSON report. The types below define its schema.

`make schema` writes docs/report.schema.json. Version 2 keeps all keys of version 1 and adds
some: a reader of version 1 can read it if it skips unknown keys.
"""

from __future__ import annotations

from typing import Annotated

import msgspec

from judge.kit.files import write_whole
from judge.kit.paths import ROOT
from judge.problem.verdict import Verdict
from judge.results import CaseResult, Judging

SCHEMA_VERSION = 2
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
    version 2.
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


class GroupReport(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One group; score is max_score or 0."""

    name: str
    verdict: Verdict
    score: Points
    max_score: Points


class Report(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A whole judging.

    scale: how many times slower this machine is than the calibrating one, null if it was not
    needed, not measurable, or the limit was given; scale_source: where that figure comes
    from, new in version 2. wall: the wall around every run, null for none. partial: not all
    test cases of the kit were chosen; only groups judged whole score.
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
        cases=[
            CaseReport(
                case=r.case.name,
                group=r.case.group,
                verdict=r.verdict,
                cpu_s=r.cpu_s,
                wall_s=r.elapsed_s,
                memory_mib=r.memory_mib,
                message=r.message,
                retried=r.retried,
                first_verdict=r.first_verdict,
                mismatch=_mismatch(r),
            )
            for r in judging.cases
        ],
    )


def _mismatch(result: CaseResult) -> MismatchReport | None:
    found = result.mismatch
    if found is None:
        return None
    return MismatchReport(found.scenario, found.line, found.column, found.expected, found.found)


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
