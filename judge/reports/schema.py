"""The JSON report: its schema, as the types below say it.

`python -m judge.reports.schema > docs/report.schema.json` writes the schema down. A field
added is still version 1; one that is taken away, or means something else, is not.
"""

from __future__ import annotations

import sys
from typing import Annotated

import msgspec

from judge.problem.verdict import Verdict
from judge.results import Judging

SCHEMA_VERSION = 1


Seconds = Annotated[float, msgspec.Meta(ge=0)]
Mebibytes = Annotated[float, msgspec.Meta(ge=0)]
Points = Annotated[int, msgspec.Meta(ge=0)]


class CaseReport(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One case, in the order of judging; verdict null: not run, and message says why."""

    case: str
    group: str
    verdict: Verdict | None
    cpu_s: Seconds
    wall_s: Seconds
    memory_mib: Mebibytes
    message: str
    retried: bool
    first_verdict: Verdict | None


class GroupReport(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One group; score is max_score or 0."""

    name: str
    verdict: Verdict
    score: Points
    max_score: Points


class Report(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A whole judging. scale: null if the machine's speed was not measured.

    wall: the kind of wall that stood around every run, null for none.
    partial: not every case was selected; only groups judged whole score.
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
        scale=judging.scale,
        wall=judging.wall,
        groups=[GroupReport(g.name, g.verdict, g.score, g.max_score) for g in judging.groups],
        cases=[
            CaseReport(
                case=r.case.name,
                group=r.case.group,
                verdict=r.verdict,
                cpu_s=r.cpu_s,
                wall_s=r.wall_s,
                memory_mib=r.memory_mib,
                message=r.message,
                retried=r.retried,
                first_verdict=r.first_verdict,
            )
            for r in judging.cases
        ],
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
    return text.replace(b"\\n    ", b"\\n")  # docstrings, without their indentation


if __name__ == "__main__":
    sys.stdout.buffer.write(json_schema())
