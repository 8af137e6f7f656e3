"""The kill matrix: which submission fails which case. What follows from it is in `analysis`."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, replace
from pathlib import Path

import msgspec

from judge.kit.files import write_whole
from judge.kit.paths import ROOT
from judge.languages.submission import CompileError, Submission, compile_submission, read_submission
from judge.pool import run_case
from judge.problem.cases import Case
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from judge.sandbox.facts import RunLimits
from judge.sandbox.sandbox import Command, Sandbox

CACHE = ROOT / "build" / "strength"


@dataclass(frozen=True, slots=True)
class Row:
    """One submission (path below submissions/) and its verdict on each case that it ran on.

    After a first TLE in a group, the group's other cases are not run: they are missing.
    """

    submission: str
    verdicts: dict[str, Verdict]  # by the case's name, in order of the cases


@dataclass(frozen=True, slots=True)
class Matrix:
    """All rows in order, and all cases in order. judged: how many runs were made, not kept."""

    rows: tuple[Row, ...]
    cases: tuple[Case, ...]
    judged: int


class _Kept:
    """The verdicts of one submission under given limits, by the sums of the case's files."""

    def __init__(self, directory: Path, source: bytes, limits: RunLimits) -> None:
        text = f"{limits.time_limit_s} {limits.memory_mib} {limits.output_mib}".encode()
        self._path = directory / f"{hashlib.sha256(source + text).hexdigest()[:32]}.json"
        self._verdicts: dict[str, Verdict] = {}
        try:
            content = self._path.read_bytes()
            self._verdicts = msgspec.json.decode(content, type=dict[str, Verdict])
        except (OSError, msgspec.DecodeError):
            self._verdicts = {}  # nothing kept, or not by this program: judge again

    def get(self, key: str) -> Verdict | None:
        return self._verdicts.get(key)

    def put(self, key: str, verdict: Verdict) -> None:
        self._verdicts[key] = verdict

    def save(self) -> None:
        write_whole(self._path, msgspec.json.encode(self._verdicts), parents=True)


def build(
    submissions: Sequence[str],
    cases: Sequence[Case],
    problem: Problem,
    limits: RunLimits,
    sandbox: Sandbox,
    *,
    scale: float = 1.0,
    jobs: int,
    cache: Path = CACHE,
    done: Callable[[str, int], None] = lambda _submission, _cases: None,
) -> Matrix:
    """Judge every submission on every case, `jobs` submissions at a time.

    limits: as declared; scale: how many times slower this machine is than the one that
    set them. A verdict is kept by the sums of source, declared limits and files, so only
    what changed is run again. done hears the submission and how many cases are behind it, often.
    Raises SubmissionError, LanguageError or SandboxError.
    """
    scaled = replace(limits, time_limit_s=limits.time_limit_s * scale)
    keys = {case.name: _sum(case) for case in cases}
    rows: dict[str, Row] = {}
    judged = 0

    def one(name: str) -> tuple[Row, int]:
        path = ROOT / "submissions" / name
        submission = read_submission(path)
        kept = _Kept(cache, path.suffix.encode() + submission.source, limits)
        runner = _Runner(submission, problem, scaled, sandbox)
        verdicts: dict[str, Verdict] = {}
        slow: set[str] = set()
        try:
            for number, case in enumerate(cases, 1):
                if case.group not in slow:
                    verdict = kept.get(keys[case.name]) or runner.verdict(case)
                    if verdict is not Verdict.JE:
                        kept.put(keys[case.name], verdict)
                    verdicts[case.name] = verdict
                    if verdict is Verdict.TLE:
                        slow.add(case.group)
                done(name, number)
        finally:
            kept.save()
        return Row(name, verdicts), runner.runs

    with ThreadPoolExecutor(jobs) as pool:
        futures = [pool.submit(one, name) for name in submissions]
        try:
            for future in as_completed(futures):
                row, runs = future.result()
                rows[row.submission] = row
                judged += runs
        except BaseException:
            for future in futures:
                future.cancel()
            sandbox.close()  # ends the runs, so that their threads end too
            raise
    return Matrix(tuple(rows[name] for name in submissions), tuple(cases), judged)


class _Runner:
    """One submission, compiled when a first run is needed."""

    def __init__(
        self, submission: Submission, problem: Problem, limits: RunLimits, sandbox: Sandbox
    ) -> None:
        self._submission = submission
        self._problem = problem
        self._limits = limits
        self._sandbox = sandbox
        self._command: Command | None = None
        self._does_not_compile = False
        self.runs = 0

    def verdict(self, case: Case) -> Verdict:
        """Run it on a case."""
        if self._command is None and not self._does_not_compile:
            try:
                program = compile_submission(self._submission, self._problem.limits, self._sandbox)
                self._command = program.command
            except CompileError:
                self._does_not_compile = True
        if self._command is None:
            return Verdict.CE
        self.runs += 1
        return run_case(self._sandbox, self._command, self._limits, case).verdict or Verdict.JE


def _sum(case: Case) -> str:
    """Return the sum of both files of a case."""
    digest = hashlib.sha256()
    for path in (case.input, case.answer):
        digest.update(hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()[:32]
