"""The JSON report: its schema, version 1, as the types below say it."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

import msgspec

from judge.results import Judging
from judge.verdict import Verdict

SCHEMA_VERSION = 1


class CaseReport(msgspec.Struct, frozen=True):
    """One case, in the order of judging; verdict null: not run, and message says why."""

    case: str
    group: str
    verdict: Verdict | None
    cpu_s: float
    wall_s: float
    memory_mib: float
    message: str
    retried: bool
    first_verdict: Verdict | None


class GroupReport(msgspec.Struct, frozen=True):
    """One group; score is max_score or 0."""

    name: str
    verdict: Verdict
    score: int
    max_score: int


class Report(msgspec.Struct, frozen=True):
    """A whole judging. scale: null if the machine's speed was not measured.

    wall: the bwrap that stood around every run, null for none.
    partial: not every case was selected; only groups judged whole score.
    """

    schema_version: int
    submission: str
    language: str
    verdict: Verdict
    score: int
    max_score: int
    partial: bool
    message: str
    time_limit_s: float
    declared_time_limit_s: float
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


def write_json(path: Path, judging: Judging) -> None:
    """Write the report beside `path` and rename it there: never half a file. Raises OSError."""
    data = msgspec.json.format(msgspec.json.encode(report_of(judging)), indent=2) + b"\n"
    handle, beside = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}-")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        Path(beside).chmod(0o644)
        Path(beside).replace(path)
    except BaseException:
        Path(beside).unlink(missing_ok=True)
        raise
