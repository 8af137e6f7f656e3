"""Judging on other executors, with workers that share nothing with this process and may die."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from judge.judging import Events, Options, judge
from judge.languages.submission import compile_submission, read_submission
from judge.pool import Job, Ready, prepare, run_task
from judge.problem.verdict import Verdict
from judge.results import CaseResult, Judging, Scale
from judge.sandbox.facts import RunLimits

from .conftest import QUIET

ECHO = "import sys\nsys.stdout.write(sys.stdin.read())\n"
Source = Callable[[str, str], Path]


@pytest.fixture
def scratch(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The directory of all scratch files, of this process and its workers."""
    directory = tmp_path / "scratch"
    directory.mkdir()
    monkeypatch.setenv("TMPDIR", str(directory))
    monkeypatch.setattr("tempfile.tempdir", str(directory))
    return directory


@pytest.fixture
def processes(scratch: Path) -> Iterator[ProcessPoolExecutor]:
    """Two fresh processes, which get everything by pickling."""
    with ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as pool:
        yield pool


def judged(path: Path, data: Path, executor: Executor | None = None, **events: Any) -> Judging:
    options = Options(data=data, no_wall=True, time_limit_s=5.0, jobs=2)
    submission = read_submission(path)
    return judge(submission, QUIET, options, executor=executor, events=Events(**events))


def told(judging: Judging) -> Judging:
    """Return a judging without what differs from run to run."""

    def alike(result: CaseResult) -> CaseResult:
        return replace(result, cpu_s=0.0, elapsed_s=0.0, memory_mib=0.0)

    groups = tuple(replace(g, cases=tuple(map(alike, g.cases))) for g in judging.groups)
    return replace(judging, groups=groups)


def nothing_left(scratch: Path) -> bool:
    """Wait until no scratch directory is left: a keeper removes its own after the worker ends."""
    give_up = time.monotonic() + 20
    while any(scratch.iterdir()) and time.monotonic() < give_up:
        time.sleep(0.02)
    return not any(scratch.iterdir())


def test_other_processes_judge_alike(
    source: Source, data: Path, scratch: Path, processes: ProcessPoolExecutor
) -> None:
    code = "s = open(0).read().split()\ns[2:] = s[2:] and ['NO']\nprint(*s)\n"
    path = source("wrong.py", code)
    here, there = judged(path, data), judged(path, data, processes)
    assert told(here) == told(there)
    assert there.verdict is Verdict.WA
    processes.shutdown()
    assert nothing_left(scratch)


def test_a_compile_error_in_another_process_is_a_verdict(
    source: Source, data: Path, processes: ProcessPoolExecutor
) -> None:
    outcome = judged(source("broken.py", "def f(:\n"), data, processes)
    assert outcome.verdict is Verdict.CE
    assert "SyntaxError" in outcome.message


def test_a_worker_killed_in_the_middle_changes_nothing(
    source: Source, data: Path, scratch: Path, processes: ProcessPoolExecutor
) -> None:
    """A worker dies while its program runs; its program is ended and its files are removed."""
    path = source("echo.py", "import time\ntime.sleep(0.3)\n" + ECHO)

    def kill_one(cases: int) -> None:
        assert cases == 4
        victim = next(iter(processes._processes))
        threading.Timer(0.4, os.kill, (victim, signal.SIGKILL)).start()

    outcome = judged(path, data, processes, start=kill_one)
    assert {r.verdict for r in outcome.cases} == {Verdict.AC}
    assert outcome.score == 30
    processes.shutdown()
    assert nothing_left(scratch)


def test_a_job_and_what_a_worker_returns_can_be_pickled(source: Source, data: Path) -> None:
    job = Job(read_submission(source("echo.py", ECHO)), QUIET, without_wall=True)
    copy = pickle.loads(pickle.dumps(job))
    assert copy == job
    broken = replace(job, submission=read_submission(source("b.py", "(")), key="broken")
    ready = pickle.loads(pickle.dumps(prepare(broken)))
    assert "SyntaxError" in ready.compile_error


class Slow(Executor):
    """Reports 6 s of CPU time for every run, and `scale` as the speed of the machine."""

    def __init__(self, scale: Scale | None) -> None:
        self.scale = scale
        self.limits_s: list[float] = []
        self.measured = 0

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        if fn is run_task:
            _, limits, case = args
            assert isinstance(limits, RunLimits)
            self.limits_s.append(limits.time_limit_s)
            verdict = Verdict.TLE if limits.time_limit_s < 6.0 else Verdict.AC
            future.set_result(CaseResult(case, verdict, 6.0, 6.0, 9.0))
        elif fn is prepare:
            future.set_result(Ready("a wall"))
        else:
            self.measured += 1
            future.set_result(self.scale)
        return future


@pytest.mark.parametrize(
    ("scale", "verdict", "limits_s"),
    [
        # Only the first run has the declared limit; its repetition and all others have the scaled.
        (Scale(1.5, "measured"), Verdict.AC, [5.0, 7.5, 7.5, 7.5, 7.5]),
        (Scale(1.0, "measured"), Verdict.TLE, [5.0] * 4),
        (None, Verdict.TLE, [5.0] * 4),  # the calibration case is not built
    ],
)
def test_the_machine_is_measured_once_a_verdict_depends_on_it(
    source: Source,
    data: Path,
    monkeypatch: pytest.MonkeyPatch,
    scale: Scale | None,
    verdict: Verdict,
    limits_s: list[float],
) -> None:
    monkeypatch.setattr("judge.judging.kept_scale", lambda _problem: None)
    executor = Slow(scale)
    submission = read_submission(source("echo.py", ECHO))
    options = Options(data=data, jobs=1, stop_on_first=False)
    outcome = judge(submission, QUIET, options, executor=executor)
    assert outcome.verdict is verdict
    assert outcome.scale == scale
    assert executor.measured == 1
    assert executor.limits_s == limits_s
    assert outcome.time_limit_s == limits_s[-1]
    assert [r.first_verdict for r in outcome.changed] == [Verdict.TLE] * (verdict is Verdict.AC)
    asked = judge(submission, QUIET, Options(data=data, time_limit_s=4.0), executor=Slow(scale))
    assert (asked.verdict, asked.time_limit_s, asked.scale) == (Verdict.TLE, 4.0, None)


def test_a_worker_compiles_once(
    source: Source, data: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    compiled: list[str] = []

    def count(*arguments: Any) -> Any:
        compiled.append("once")
        return compile_submission(*arguments)

    monkeypatch.setattr("judge.pool.compile_submission", count)
    assert judged(source("echo.py", ECHO), data).verdict is Verdict.AC
    assert compiled == ["once"]


def test_a_verdict_under_another_limit_is_not_kept(
    source: Source, data: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept: list[object] = []
    monkeypatch.setattr("judge.judging.KeptVerdicts.keep", lambda _self, found: kept.append(found))
    submission = read_submission(source("echo.py", ECHO))
    judge(submission, QUIET, Options(data=data, no_wall=True, time_limit_s=9.0))
    assert kept == []
    judge(submission, QUIET, Options(data=data, no_wall=True))
    assert len(kept) == 1
