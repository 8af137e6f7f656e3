"""Judges one submission on every chosen test case and returns the results in order."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from pathlib import Path

from judge.diagnosis.diagnose import after_example, diagnose
from judge.diagnosis.gallery import load_gallery
from judge.diagnosis.slowness import first_timeout, size_of
from judge.explanation import Counterexample, Growth, Slowness
from judge.kept import KeptVerdicts
from judge.kit.errors import KitError
from judge.kit.paths import BRUTE_FORCE, DATA, REFERENCE, SUBMISSIONS
from judge.kit.store import Store
from judge.kit.text import printable_name
from judge.languages.submission import Submission
from judge.machine import kept_scale
from judge.pool import Job, Pending, Pool, Ready
from judge.problem.data import Data, load_data
from judge.problem.declaration import Problem
from judge.problem.given import wrong_answer_in
from judge.problem.manifest import Manifest
from judge.problem.order import judging_order
from judge.problem.verdict import Verdict
from judge.results import CaseResult, Judging, Scale, first_failure, group_results, not_run
from judge.run import Attempts, declared_limits
from judge.sandbox.facts import RunLimits
from judge.sandbox.probe import NoWallError

UNEXPLAINED = (Verdict.AC, Verdict.CE, Verdict.JE)


class JudgeError(KitError):
    """The submission cannot be judged."""


@dataclass(frozen=True, slots=True)
class Options:
    """What to judge on, and how. Empty groups or globs: all.

    time_limit_s: replaces the declared limit, and is not scaled to this machine.
    stop_on_first: a group ends at its first failure, as its points are all or nothing; False:
    every case is run.
    no_wall: if no wall works, run even programs that are not the kit's own.
    compact: judge only on the small selection of cases, `compact.json`.
    scale: of this machine, if it is known; None: the kept one, or measured when it is needed.
    hidden: directories that no program may see, besides the data and those of the kit.
    """

    data: Path = DATA
    groups: tuple[str, ...] = ()
    globs: tuple[str, ...] = ()
    jobs: int = 1
    time_limit_s: float | None = None
    stop_on_first: bool = True
    no_wall: bool = False
    compact: bool = False
    scale: Scale | None = None
    hidden: tuple[Path, ...] = ()


@dataclass(frozen=True, slots=True)
class Events:
    """Functions that report the progress of a judging; called from the judging's thread."""

    phase: Callable[[str], None] = lambda _text: None
    start: Callable[[int], None] = lambda _cases: None
    result: Callable[[CaseResult], None] = lambda _result: None


@dataclass(frozen=True, slots=True)
class Failure:
    """A submission that was judged and is not accepted, and the means to find out more.

    cases: the results, in order. attempts: runs it on texts of input files, `jobs` at a time,
    and yields the runs in order. limits: those of the judging. say: tells the user what is
    being done now.
    """

    submission: Submission
    problem: Problem
    cases: tuple[CaseResult, ...]
    attempts: Attempts
    limits: RunLimits
    jobs: int
    say: Callable[[str], None]


Search = Callable[[Failure], Counterexample | str]  # or why there is none; raises KitError
Measure = Callable[[Failure], tuple[Growth, ...]]  # raises KitError


def judge(
    submission: Submission,
    problem: Problem,
    options: Options | None = None,
    *,
    events: Events | None = None,
    executor: Executor | None = None,
    search: Search | None = None,
    measure: Measure | None = None,
) -> Judging:
    """Judge `submission` and return all results.

    executor: carries out `options.jobs` runs at a time; None: threads. Its workers
    need the kit, the data at the same paths, and a place for scratch files. search: finds the
    counterexample for a program that is not accepted; None: there is none in the results.
    measure: finds out how the time of a program grows that was too slow; None: nothing does.
    Raises KitError if nothing can be judged; a single run that fails for a fault of the
    machine is JE. After any exception, even Ctrl-C, no process and no file is left.
    """
    options, events = options or Options(), events or Events()
    without_wall = options.no_wall or _vouched_for(submission, problem)
    job = Job(
        submission,
        problem,
        without_wall,
        keepers=options.jobs if executor is None else 1,
        hidden=(options.data, *options.hidden),
    )
    events.phase(f"compiling {printable_name(submission.name)} ({submission.language.name})")
    with Store() as store, Pool(job, options.jobs, executor) as pool:
        compiling = pool.prepare()  # goes on while the data is checked
        data = load_data(
            problem, options.data, options.groups, options.globs, store, compact=options.compact
        )
        time_limit = _TimeLimit(problem, options, pool, events)
        cases = judging_order(options.data, data.chosen)
        ready = wait_until_ready(pool, compiling, submission)
        results: list[CaseResult] = []
        if not ready.compile_error:
            events.start(len(cases))
            for result in pool.in_order(
                cases,
                time_limit.limits,
                stop_on_first=options.stop_on_first,
                limits_here=time_limit.limits_here,
            ):
                events.result(result)
                results.append(result)
            if options.time_limit_s is None:
                declared = time_limit.limits._replace(time_limit_s=time_limit.declared_s)
                kept = KeptVerdicts(store, submission, declared, data.manifest)
                kept.keep({r.case.name: r.verdict for r in results if r.verdict is not None})
        else:
            results = [not_run(case, "does not compile") for case in cases]
        judging = _judging(submission, problem, data, time_limit, results, ready)
        if judging.verdict in UNEXPLAINED or not problem.feedback.lessons:
            return judging
        failure = Failure(
            submission,
            problem,
            judging.cases,
            pool.attempts,
            time_limit.limits,
            options.jobs,
            events.phase,
        )
        explained = _explained(judging, failure, search)
        return _with_slowness(explained, failure, data.manifest, measure)


def _explained(judging: Judging, failure: Failure, search: Search | None) -> Judging:
    """Return the judging with a diagnosis, and the counterexample that a search finds.

    Whatever goes wrong here costs only the explanation: the results are kept.
    """
    problem = failure.problem
    try:
        failure.say("looking for the lesson")
        if doubt := _doubt(judging.first_failure):
            return replace(judging, unexplained=doubt)
        gallery = load_gallery()
        found = diagnose(gallery, failure.attempts, failure.limits, problem, failure.cases)
        judging = replace(judging, diagnosis=found)
        if search is None or not problem.feedback.counterexample:
            return judging
        example = search(failure)
    except KitError as error:
        return replace(judging, unexplained=str(error))
    if isinstance(example, str):
        return replace(judging, unexplained=example)
    if found is not None:
        found = after_example(gallery, found, example)
    return replace(judging, diagnosis=found, counterexample=example)


def _with_slowness(
    judging: Judging, failure: Failure, manifest: Manifest, measure: Measure | None
) -> Judging:
    """Return the judging with what is known about a time limit that was exceeded."""
    late = first_timeout(judging.cases)
    if late is None:
        return judging
    size = size_of(late.case, failure.problem, manifest)
    judging = replace(judging, slowness=None if size is None else Slowness(size))
    if measure is None:
        return judging
    try:
        return replace(judging, slowness=Slowness(size, measure(failure)))
    except KitError as error:
        said = (judging.unexplained, str(error))
        return replace(judging, unexplained="; ".join(filter(None, said)))


def _doubt(result: CaseResult | None) -> str:
    """Return why the answer file of a failed case is itself in doubt; the kit's own never are."""
    if result is None or result.mismatch is None or result.case.input.is_relative_to(DATA):
        return ""
    if result.mismatch.expected is None:
        return ""
    return wrong_answer_in(result.case, result.mismatch.scenario)


def _judging(
    submission: Submission,
    problem: Problem,
    data: Data,
    time_limit: _TimeLimit,
    results: list[CaseResult],
    ready: Ready,
) -> Judging:
    """Return the whole judging."""
    groups = group_results(problem, data.all, results)
    if ready.compile_error:
        groups = tuple(replace(group, verdict=Verdict.CE, score=0) for group in groups)
    return Judging(
        submission=printable_name(submission.name),
        language=submission.language.name,
        verdict=first_failure(group.verdict for group in groups),
        score=sum(group.score for group in groups),
        max_score=problem.max_score,
        partial=data.partial,
        time_limit_s=time_limit.limits.time_limit_s,
        declared_s=time_limit.declared_s,
        memory_mib=time_limit.limits.memory_mib,
        scale=time_limit.scale,
        groups=groups,
        message=ready.compile_error,
        wall=ready.wall,
        limit_given=time_limit.given,
    )


class _TimeLimit:
    """The limits of a judging, scaled to this machine as soon as a verdict depends on it.

    The scale can only raise the time limit, so it is measured when a run first goes over the
    declared one. A scale that was kept from an earlier judging is used from the beginning.
    """

    def __init__(self, problem: Problem, options: Options, pool: Pool, events: Events) -> None:
        self._pool = pool
        self._events = events
        asked_s = options.time_limit_s
        self.given = asked_s is not None
        self.declared_s = problem.limits.time_limit_s
        self.scale: Scale | None = None if self.given else options.scale or kept_scale(problem)
        self._base = declared_limits(problem.limits, asked_s)

    @property
    def limits(self) -> RunLimits:
        """The current limits; they are not scaled before the scale is known."""
        factor = 1.0 if self.scale is None else self.scale.factor
        return self._base._replace(time_limit_s=self._base.time_limit_s * factor)

    def limits_here(self) -> RunLimits:
        """Return the limits as they hold on this machine, which may have to be measured now."""
        if self.scale is None and not self.given:
            self._events.phase("timing the reference solution")
            self.scale = self._pool.measure_scale()
            self._events.phase("judging")
        return self.limits


def wait_until_ready(pool: Pool, compiling: Pending[Ready], submission: Submission) -> Ready:
    """Wait for a worker to be ready. Raises JudgeError where no wall works."""
    try:
        return pool.result(compiling)
    except NoWallError as error:
        raise JudgeError(
            f"no wall works here ({error}), so {submission.name} could read, change and send "
            "whatever you can; if you trust it, say --no-wall"
        ) from None


def _vouched_for(submission: Submission, problem: Problem) -> bool:
    """Tell whether the kit vouches for it: its reference, brute force, declared submissions."""
    own = (REFERENCE, BRUTE_FORCE, *(SUBMISSIONS / name for name in problem.submissions))
    return submission.file is not None and any(
        submission.file == (found.st_dev, found.st_ino)
        for found in (path.stat() for path in own if path.is_file())
    )
