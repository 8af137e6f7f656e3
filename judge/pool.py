"""The workers that judge one submission, and its test cases spread over them.

A worker is a process with a sandbox of its own and the submission compiled in it. Tasks are
plain data, so that any `concurrent.futures.Executor` can carry them to its workers: threads
of this process (which then is the one worker), other processes, or a cluster.
"""

from __future__ import annotations

import atexit
import secrets
import threading
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from types import TracebackType
from typing import Any, Self, TypeVar

from judge.languages.submission import Program, Submission, compile_submission
from judge.machine import measure_scale
from judge.problem.cases import Case
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from judge.results import CaseResult, Scale, not_run
from judge.run import run_case
from judge.sandbox.facts import RunLimits
from judge.sandbox.probe import NoWallError, walled_sandbox
from judge.sandbox.retry import repeat_alone
from judge.sandbox.sandbox import Sandbox

T = TypeVar("T")
EARLIER_FAILED = "an earlier case of its group failed"


@dataclass(frozen=True, slots=True)
class Job:
    """What a worker needs to judge one submission: plain data.

    without_wall: the program may run without a wall where none works. key: tells judgings
    apart, so that a worker gets ready once for each.
    """

    submission: Submission
    problem: Problem
    without_wall: bool
    key: str = field(default_factory=lambda: secrets.token_hex(8))


class Worker:
    """A sandbox, and the submission compiled in it. Raises NoWallError, SandboxError."""

    def __init__(self, job: Job) -> None:
        self._job = job
        self._lock = threading.Lock()
        self._program: Program | None = None
        self.users = 0  # tasks that are using it now
        try:
            self.sandbox = walled_sandbox()
        except NoWallError:
            if not job.without_wall:
                raise
            self.sandbox = Sandbox()

    @property
    def program(self) -> Program:
        """The compiled submission. Raises CompileError, LanguageError, SandboxError."""
        with self._lock:
            if self._program is None:
                job = self._job
                limits = job.problem.limits
                self._program = compile_submission(job.submission, limits, self.sandbox)
            return self._program


class _Workers:
    """The workers of this process, by job: an executor keeps nothing between two tasks."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._workers: dict[str, Worker] = {}

    @contextmanager
    def using(self, job: Job) -> Iterator[Worker]:
        """Yield the worker for a job. Making a new one closes those that no task uses."""
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
        """Close the worker of a job if there is one: what it is doing ends."""
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


def prepare(job: Job) -> str | None:
    """Task: compile the submission; return the wall that is around its runs, None for none.

    Raises NoWallError, CompileError, LanguageError, SandboxError, as the other tasks do.
    """
    with _WORKERS.using(job) as worker:
        wall = worker.sandbox.wall
        assert worker.program
        return None if wall is None else str(wall)


def run_task(job: Job, limits: RunLimits, case: Case) -> CaseResult:
    """Task: run the submission on one test case."""
    with _WORKERS.using(job) as worker:
        return run_case(worker.sandbox, worker.program, limits, case)


def scale_task(job: Job) -> Scale | None:
    """Task: measure how fast the worker's machine is. Raises MachineError, too."""
    with _WORKERS.using(job) as worker:
        return measure_scale(job.problem, worker.sandbox)


@dataclass(slots=True)
class _Running:
    """A run under way. beside_others: others may go on beside it."""

    case: Case
    limits: RunLimits
    beside_others: bool
    future: Future[CaseResult] | None  # None: it is not run


class Pool:
    """The workers of one job, and `jobs` runs at a time on them.

    executor: where its tasks are carried out; threads of this process if None. A worker that
    breaks costs a second try, in this process, and never a result.
    """

    def __init__(self, job: Job, jobs: int, executor: Executor | None = None) -> None:
        self._job = job
        self._jobs = jobs
        self._threads = ThreadPoolExecutor(jobs)  # starts no thread that is not used
        self._executor = executor or self._threads

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._threads.shutdown(wait=False, cancel_futures=True)
        _WORKERS.close(self._job.key)  # ends what its threads wait for
        self._threads.shutdown()
        _WORKERS.close(self._job.key)  # a thread may just have begun with it

    def prepare(self) -> Future[str | None]:
        """Make a worker ready; see `prepare`."""
        return self._submit(prepare, self._job)

    def measure_scale(self) -> Scale | None:
        """Measure the machine's speed; see `scale_task`."""
        return self.result(self._submit(scale_task, self._job))

    def result(self, future: Future[T]) -> T:
        """Wait for a result, a second at a time.

        Python handles a signal only between two of its steps, so one that comes just before a
        wait without an end would never be handled.
        """
        while wait([future], timeout=1).not_done:
            pass
        return future.result()

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
        called when a run first goes over the time limit, while nothing else runs. When a run is
        repeated, alone, that run decides (see `judge.sandbox.retry`).
        """
        waiting = deque(cases)
        running: deque[_Running] = deque()
        stopped: set[str] = set()  # groups with a failure, if that ends a group
        known = False  # whether `limits` are those of this machine
        while waiting or running:
            while waiting and len(running) < self._jobs:
                running.append(self._start(waiting.popleft(), limits, stopped))
            run = running.popleft()
            if run.future is None or run.case.group in stopped:
                yield not_run(run.case, EARLIER_FAILED)
                continue
            result = self._result(run)
            if result.verdict is Verdict.TLE:
                for other in running:
                    self._await(other)
                if not known:
                    limits, known = limits_here(), True
                if limits != run.limits or repeat_alone(
                    result.cpu_s, limits, beside_others=run.beside_others
                ):
                    result = self._repeated(result, limits)
            if stop_on_first and result.verdict not in (None, Verdict.AC):
                stopped.add(run.case.group)
            yield result

    def _start(self, case: Case, limits: RunLimits, stopped: set[str]) -> _Running:
        future = None
        if case.group not in stopped:
            future = self._submit(run_task, self._job, limits, case)
        return _Running(case, limits, self._jobs > 1, future)

    def _submit(self, task: Callable[..., T], *arguments: Any) -> Future[T]:
        try:
            return self._executor.submit(task, *arguments)
        except RuntimeError:  # a broken pool takes no more tasks
            return self._threads.submit(task, *arguments)

    def _result(self, run: _Running) -> CaseResult:
        assert run.future is not None
        try:
            return self.result(run.future)
        except Exception:
            again = self._threads.submit(run_task, self._job, run.limits, run.case)
            return self.result(again)

    def _await(self, run: _Running) -> None:
        while run.future is not None and wait([run.future], timeout=1).not_done:
            pass

    def _repeated(self, first: CaseResult, limits: RunLimits) -> CaseResult:
        future = self._submit(run_task, self._job, limits, first.case)
        result = self._result(_Running(first.case, limits, False, future))
        changed = first.verdict if result.verdict is not first.verdict else None
        return replace(result, retried=True, first_verdict=changed)
