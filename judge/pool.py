"""Runs of a compiled submission: one case judged, or many on an executor, results in order."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from concurrent.futures import Executor, Future, wait
from dataclasses import replace

from judge.compare import compare
from judge.decide import decide
from judge.languages.submission import Program
from judge.problem.cases import Case
from judge.problem.verdict import Verdict
from judge.results import CaseResult, not_run
from judge.sandbox.facts import RunLimits
from judge.sandbox.sandbox import Command, Sandbox, SandboxError

RUNS_BEFORE_JE = 2


def run_case(sandbox: Sandbox, command: Command, limits: RunLimits, case: Case) -> CaseResult:
    """Run a program on one case and judge it. A failure of the sandbox, twice, is JE."""
    failure = ""
    for _ in range(RUNS_BEFORE_JE):
        directory = sandbox.new_directory("output-")
        output = directory / "stdout"
        try:
            facts = sandbox.run(command, limits, stdin=case.input, stdout=output)
            with output.open("rb") as found, case.answer.open("rb") as expected:
                judgement = decide(facts, limits, compare(found, expected))
        except (SandboxError, OSError) as error:
            failure = str(error)
            continue
        finally:
            output.unlink(missing_ok=True)
            if directory.is_dir():
                directory.rmdir()
        return CaseResult(
            case,
            judgement.verdict,
            round(facts.cpu_s, 4),
            round(facts.wall_s, 4),
            round(facts.memory_mib, 2),
            judgement.message,
        )
    return CaseResult(case, Verdict.JE, 0.0, 0.0, 0.0, failure)


class Runs:
    """Runs cases on an executor, some at a time, and yields their results in order."""

    def __init__(
        self,
        sandbox: Sandbox,
        program: Program,
        limits: RunLimits,
        executor: Executor,
        *,
        jobs: int,
        stop_on_first: bool,
    ) -> None:
        self._executor = executor
        self._task = (sandbox, program.command, limits)
        self._jobs = jobs
        self._stop_on_first = stop_on_first

    def in_order(self, cases: Sequence[Case]) -> Iterator[CaseResult]:
        """Yield one result per case.

        What was over the time limit beside others, or not by much, runs again, alone, and
        that run decides: what disturbs a measurement only ever adds to it.
        """
        waiting = deque(cases)
        running: deque[tuple[Case, Future[CaseResult], bool]] = deque()
        stopped: set[str] = set()  # groups with a failure, if that ends a group
        while waiting or running:
            while waiting and len(running) < self._jobs:
                case = waiting.popleft()
                if case.group in stopped:
                    running.append((case, self._skipped(case), False))
                else:
                    running.append((case, self._submit(case), self._jobs > 1))
            case, future, beside_others = running.popleft()
            result = self._result(case, future)
            if case.group in stopped:
                result = not_run(case, "an earlier case of its group failed")
            elif result.verdict is Verdict.TLE and (beside_others or self._near(result)):
                result = self._again_alone(result, [future for _, future, _ in running])
            if self._stop_on_first and result.verdict not in (None, Verdict.AC):
                stopped.add(case.group)
            yield result

    def _submit(self, case: Case) -> Future[CaseResult]:
        return self._executor.submit(run_case, *self._task, case)

    def _skipped(self, case: Case) -> Future[CaseResult]:
        future: Future[CaseResult] = Future()
        future.set_result(not_run(case, "an earlier case of its group failed"))
        return future

    def _result(self, case: Case, future: Future[CaseResult]) -> CaseResult:
        """Wait for a result; a broken worker costs a second try, never the result."""
        _await([future])
        try:
            return future.result()
        except Exception:
            return run_case(*self._task, case)

    def _near(self, result: CaseResult) -> bool:
        """Was this run over the limit, but came to its own end? Then not by much."""
        limits = self._task[2]
        return limits.time_limit_s < result.cpu_s <= limits.kill_cpu_s

    def _again_alone(self, first: CaseResult, others: list[Future[CaseResult]]) -> CaseResult:
        _await(others)
        result = run_case(*self._task, first.case)
        changed = first.verdict if result.verdict is not first.verdict else None
        return replace(result, retried=True, first_verdict=changed)


def _await(futures: list[Future[CaseResult]]) -> None:
    """Wait for all, but a second at a time.

    Python acts on a signal only between two of its steps: one that comes just before a
    wait without an end would never be seen.
    """
    while wait(futures, timeout=1).not_done:
        pass
