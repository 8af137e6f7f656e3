"""The kill matrix: which submission fails which case. What follows from it is in `analysis`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass

from judge.kept import KeptVerdicts
from judge.kit.paths import SUBMISSIONS
from judge.kit.store import Store
from judge.languages.submission import CompileError, Program, compile_submission, read_submission
from judge.problem.cases import Case
from judge.problem.data import Data
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from judge.run import declared_limits, run_case
from judge.sandbox.sandbox import Sandbox


@dataclass(frozen=True, slots=True)
class Row:
    """One submission (path below submissions/) and its verdict on each case that it ran on.

    After a first TLE in a group, the group's other cases are missing: they are not run, unless
    they were asked for.
    """

    submission: str
    verdicts: dict[str, Verdict]  # by the case's name, in order of the cases


@dataclass(frozen=True, slots=True)
class Matrix:
    """All rows in order, and all cases in order. judged: how many runs were made, not kept."""

    rows: tuple[Row, ...]
    cases: tuple[Case, ...]
    judged: int


# Names the next case to run after a group's first TLE, or None: from the submission, the group and
# the verdicts so far.
Further = Callable[[str, str, Mapping[str, Verdict]], Case | None]


def nothing_further(_submission: str, _group: str, _verdicts: Mapping[str, Verdict]) -> None:
    """Ask for no more runs."""


def build(
    submissions: Sequence[str],
    data: Data,
    problem: Problem,
    sandbox: Sandbox,
    store: Store,
    *,
    scale: float = 1.0,
    jobs: int,
    done: Callable[[str], None] = lambda _submission: None,
    further: Further = nothing_further,
) -> Matrix:
    """Judge every submission on the chosen cases of the data, `jobs` submissions at a time.

    scale: how many times slower this machine is than the one that set the limits. store:
    keeps the verdicts, so that only what changed is run again. done: called with the
    submission for each case that is behind it. further: asks for more runs. Raises
    SubmissionError, LanguageError, SandboxError, OSError.
    """
    rows: dict[str, Row] = {}
    judged = 0
    with ThreadPoolExecutor(jobs) as pool:
        judges = [_Judge(name, data, problem, scale, sandbox, store) for name in submissions]
        futures = [pool.submit(judge.row, done, further) for judge in judges]
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
    return Matrix(tuple(rows[name] for name in submissions), data.chosen, judged)


class _Judge:
    """Judges one submission, which is compiled when a first run is needed."""

    def __init__(
        self, name: str, data: Data, problem: Problem, scale: float, sandbox: Sandbox, store: Store
    ) -> None:
        limits = declared_limits(problem.limits)
        self._name = name
        self._submission = read_submission(SUBMISSIONS / name)
        self._cases = data.chosen
        self._kept = KeptVerdicts(store, self._submission, limits, data.manifest)
        self._limits = limits._replace(time_limit_s=limits.time_limit_s * scale)
        self._problem = problem
        self._sandbox = sandbox
        self._program: Program | None = None
        self._does_not_compile = False
        self._runs = 0

    def row(self, done: Callable[[str], None], further: Further) -> tuple[Row, int]:
        """Return the row, and how many runs were made for it."""
        verdicts: dict[str, Verdict] = {}
        slow: set[str] = set()  # groups with a TLE
        kept = self._kept.look_up(self._cases)
        for case in self._cases:
            if case.group not in slow:
                verdict = kept.get(case.name) or self._judged(case)
                verdicts[case.name] = verdict
                if verdict is Verdict.TLE:
                    slow.add(case.group)
            done(self._name)
        for group in sorted(slow):
            while more := further(self._name, group, verdicts):
                verdicts[more.name] = kept.get(more.name) or self._judged(more)
        in_order = {case.name: verdicts[case.name] for case in self._cases if case.name in verdicts}
        return Row(self._name, in_order), self._runs

    def _judged(self, case: Case) -> Verdict:
        """Run the submission on a case, and keep the verdict."""
        if self._program is None and not self._does_not_compile:
            try:
                self._program = compile_submission(
                    self._submission, self._problem.limits, self._sandbox
                )
            except CompileError:
                self._does_not_compile = True
        if self._program is None:
            return Verdict.CE
        self._runs += 1
        result = run_case(self._sandbox, self._program, self._limits, case)
        verdict = result.verdict or Verdict.JE
        self._kept.keep({case.name: verdict})
        return verdict
