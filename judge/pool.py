"""The workers that judge one submission, and the distribution of test cases among them.

A worker is a process with a sandbox of its own, in which the submission is compiled. Tasks are
plain data, so any `concurrent.futures.Executor` can carry them out: with threads of this
process (which then is the only worker), in other processes, or on a cluster.
"""

from __future__ import annotations

import atexit
import secrets
import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Generic, Self, TypeVar

from judge.kit.errors import KitError
from judge.languages.submission import CompileError, Program, Submission, compile_submission
from judge.machine import measure_scale
from judge.problem.cases import Case
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from judge.results import CaseResult, Scale, not_run
from judge.run import Attempt, run_case, run_input
from judge.sandbox.facts import RunLimits
from judge.sandbox.probe import walled_sandbox

T = TypeVar("T")
AHEAD = 8  # how many cases for each job may be started before the first one has ended
EARLIER_FAILED = "an earlier case of its group failed"


@dataclass(frozen=True, slots=True)
class Job:
    """What a worker needs to judge one submission: plain data.

    without_wall: the program may run without a wall where none works. keepers: how many to
    start in advance, one for each run at a time. hidden: directories that no program may see,
    besides those of the kit. key: tells judgings apart, so that a worker compiles once for each.
    """

    submission: Submission
    problem: Problem
    without_wall: bool
    keepers: int = 1
    hidden: tuple[Path, ...] = ()
    key: str = field(default_factory=lambda: secrets.token_hex(8))


class Worker:
    """A sandbox, and the submission compiled in it. Raises NoWallError, SandboxError."""

    def __init__(self, job: Job) -> None:
        self._job = job
        self._lock = threading.Lock()
        self._program: Program | None = None
        self.users = 0  # tasks that are using it now
        self.sandbox = walled_sandbox(job.keepers, job.hidden, without_wall=job.without_wall)

    def compile(self) -> Program:
        """Return the compiled submission; only the first call compiles.

        Raises CompileError, LanguageError, SandboxError.
        """
        with self._lock:
            if self._program is None:
                job = self._job
                limits = job.problem.limits
                self._program = compile_submission(job.submission, limits, self.sandbox)
            return self._program


class _Workers:
    """The workers of this process, by job. An executor itself keeps nothing between tasks."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._workers: dict[str, Worker] = {}

    @contextmanager
    def using(self, job: Job) -> Iterator[Worker]:
        """Yield the worker for a job. If it must be made, unused workers are closed first."""
        with self._lock:
            if job.key not in self._workers:
                idle = [key for key, worker in self._workers.items() if not worker.users]
                for key in idle:
                    self._workers.pop(key).sandbox.close()
                self._workers[job.key] = Worker(job)
            worker = self._workers[job.key]
            worker.users += 1
        try:
            yield worker
        finally:
            with self._lock:
                worker.users -= 1

    def close(self, key: str) -> None:
        """Close the worker of a job if there is one, which stops its runs."""
        with self._lock:
            worker = self._workers.pop(key, None)
        if worker is not None:
            worker.sandbox.close()

    def close_all(self) -> None:
        """Close all workers."""
        for key in list(self._workers):
            self.close(key)


_WORKERS = _Workers()
atexit.register(_WORKERS.close_all)


@dataclass(frozen=True, slots=True)
class Ready:
    """A worker that is ready. wall: the wall around its runs, None if there is none.

    compile_error: why the submission does not compile, empty if it does.
    """

    wall: str | None
    compile_error: str = ""


def prepare(job: Job) -> Ready:
    """Task: compile the submission. Raises NoWallError, LanguageError, SandboxError."""
    with _WORKERS.using(job) as worker:
        wall = worker.sandbox.protection
        try:
            worker.compile()
        except CompileError as error:
            return Ready(wall, str(error))
        return Ready(wall)


def run_task(job: Job, limits: RunLimits, case: Case) -> CaseResult:
    """Task: run the submission on one test case. Raises no KitError: that is the case's JE."""
    try:
        with _WORKERS.using(job) as worker:
            return run_case(worker.sandbox, worker.compile(), limits, case)
    except KitError as error:
        return CaseResult(case, Verdict.JE, 0.0, 0.0, 0.0, str(error))


def input_task(job: Job, limits: RunLimits, content: bytes) -> Attempt:
    """Task: run the submission on the text of an input file. Raises SandboxError."""
    with _WORKERS.using(job) as worker:
        return run_input(worker.sandbox, worker.compile(), limits, content)


def scale_task(job: Job) -> Scale | None:
    """Task: measure how fast the worker's machine is. Raises MachineError, SandboxError."""
    with _WORKERS.using(job) as worker:
        return measure_scale(job.problem, worker.sandbox)


@dataclass(frozen=True, slots=True)
class Pending(Generic[T]):
    """A task that an executor carries out."""

    future: Future[T]
    task: Callable[..., T]
    arguments: tuple[Any, ...]


@dataclass(frozen=True, slots=True)
class _Run:
    """A run under way; pending None: it is not run."""

    case: Case
    limits: RunLimits
    pending: Pending[CaseResult] | None


class Pool:
    """The workers of one job, with `jobs` runs at a time.

    executor: carries out the tasks; None: threads of this process. If a worker breaks, its
    task is tried again in this process, so no result is lost.
    """

    def __init__(self, job: Job, jobs: int, executor: Executor | None = None) -> None:
        self._job = job
        self._jobs = jobs
        self._threads = ThreadPoolExecutor(jobs)  # starts threads only when needed
        self._executor = executor or self._threads

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        self._threads.shutdown(wait=False, cancel_futures=True)
        _WORKERS.close(self._job.key)  # stops the runs that its threads wait for
        self._threads.shutdown()
        _WORKERS.close(self._job.key)  # a thread may have made a new one meanwhile

    def prepare(self) -> Pending[Ready]:
        """Start to prepare a worker; see the task `prepare`."""
        return self._start(prepare, self._job)

    def measure_scale(self) -> Scale | None:
        """Measure the machine's speed; see `scale_task`."""
        return self.result(self._start(scale_task, self._job))

    def attempts(self, contents: Iterable[bytes], limits: RunLimits) -> Iterator[Attempt]:
        """Yield one run per input, in order, `jobs` at a time. Raises SandboxError.

        If the caller stops early, runs under way end by themselves.
        """
        running: deque[Pending[Attempt]] = deque()
        for content in contents:
            running.append(self._start(input_task, self._job, limits, content))
            if len(running) > self._jobs:
                yield self.result(running.popleft())
        while running:
            yield self.result(running.popleft())

    def result(self, pending: Pending[T]) -> T:
        """Wait for a result. If the worker broke, try again. Raises the KitError of the task."""
        _wait_for(pending.future)
        try:
            return pending.future.result()
        except KitError:
            raise
        except Exception:
            again = self._threads.submit(pending.task, *pending.arguments)
            _wait_for(again)
            return again.result()

    def in_order(
        self,
        cases: Sequence[Case],
        limits: RunLimits,
        *,
        stop_on_first: bool,
        limits_here: Callable[[], RunLimits],
    ) -> Iterator[CaseResult]:
        """Yield one result per case, in order.

        limits_here: returns the limits as they hold on this machine, at least `limits`; it is
        called when a run first goes over the time limit, while nothing else runs. If they are
        larger, such runs are repeated, and the repeated run decides.
        """
        waiting = deque(cases)
        running: deque[_Run] = deque()
        stopped: set[str] = set()  # groups that ended at a failure
        known = False  # whether `limits` are scaled to this machine
        most = AHEAD * self._jobs  # results may wait for that of an earlier case
        while waiting or running:
            under_way = _under_way(running)
            first_is_done = bool(running) and running[0] not in under_way
            if waiting and len(running) < most and not first_is_done:
                if len(under_way) < self._jobs:
                    running.append(self._run(waiting.popleft(), limits, stopped))
                else:  # whichever ends first makes room for another
                    wait(_futures(under_way), timeout=1, return_when=FIRST_COMPLETED)
                continue
            run = running.popleft()
            if run.pending is None or run.case.group in stopped:
                yield not_run(run.case, EARLIER_FAILED)
                continue
            result = self.result(run.pending)
            if result.verdict is Verdict.TLE:
                if not known:
                    for future in _futures(running):  # nothing else runs during the measurement
                        _wait_for(future)
                    limits, known = limits_here(), True
                if limits != run.limits:
                    result = self._repeated(result, limits)
            if stop_on_first and result.verdict not in (None, Verdict.AC):
                stopped.add(run.case.group)
            yield result

    def _run(self, case: Case, limits: RunLimits, stopped: set[str]) -> _Run:
        runs = case.group not in stopped
        pending = self._start(run_task, self._job, limits, case) if runs else None
        return _Run(case, limits, pending)

    def _repeated(self, first: CaseResult, limits: RunLimits) -> CaseResult:
        result = self.result(self._start(run_task, self._job, limits, first.case))
        changed = first.verdict if result.verdict is not first.verdict else None
        return replace(result, retried=True, first_verdict=changed)

    def _start(self, task: Callable[..., T], *arguments: Any) -> Pending[T]:
        try:
            future = self._executor.submit(task, *arguments)
        except RuntimeError:  # a broken executor takes no more tasks
            future = self._threads.submit(task, *arguments)
        return Pending(future, task, arguments)


def _futures(runs: Iterable[_Run]) -> list[Future[CaseResult]]:
    """Return the futures of those that were started."""
    return [run.pending.future for run in runs if run.pending is not None]


def _under_way(runs: Iterable[_Run]) -> list[_Run]:
    """Return those that were started and have not ended."""
    return [run for run in runs if run.pending is not None and not run.pending.future.done()]


def _wait_for(future: Future[Any]) -> None:
    """Wait, one second at a time.

    Python handles signals only between its own steps. If a signal came just before a wait
    without a timeout, it would not be handled until the wait ended.
    """
    while wait([future], timeout=1).not_done:
        pass
