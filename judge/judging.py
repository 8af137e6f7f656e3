"""All runs of one submission: compiled once, every case judged, results in order."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import Executor, ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

from judge.kit.errors import KitError
from judge.kit.paths import DATA, ROOT
from judge.kit.text import printable_name
from judge.languages.submission import CompileError, Submission, compile_submission, read_submission
from judge.pool import Runs, run_case
from judge.problem.cases import Case, check_built, find_cases, select
from judge.problem.declaration import Problem
from judge.problem.manifest import check_complete, check_sums, load_manifest
from judge.problem.verdict import Verdict
from judge.results import CaseResult, Judging, first_failure, group_results, not_run
from judge.sandbox.facts import RunLimits
from judge.sandbox.probe import probe
from judge.sandbox.sandbox import Sandbox
from judge.sandbox.wall import Wall

REFERENCE = ROOT / "solution.py"
SUBMISSIONS = ROOT / "submissions"
CALIBRATION_LIMIT_FACTOR = 100.0  # a machine slower than this is out of order
SCALE_RUNS = 3


class JudgeError(KitError):
    """The judge cannot judge; one clear line."""


def default_jobs() -> int:
    """Half of the processors: the two threads of one core would slow each other down."""
    return max(1, len(os.sched_getaffinity(0)) // 2)


@dataclass(frozen=True, slots=True)
class Options:
    """What to judge on, and how. Empty groups or globs: all.

    time_limit_s: overrides the declared limit, and then nothing is scaled;
    scale: the machine's speed scale if it is known already (see `machine_scale`).
    no_wall: run even code that nobody vouches for when no wall stands.
    """

    data: Path = DATA
    groups: tuple[str, ...] = ()
    globs: tuple[str, ...] = ()
    jobs: int = 1
    time_limit_s: float | None = None
    scale: float | None = None
    stop_on_first: bool = False
    no_wall: bool = False


@dataclass(frozen=True, slots=True)
class Events:
    """What a report may want to hear while a judging goes on; called from the judging's thread."""

    phase: Callable[[str], None] = lambda _text: None
    start: Callable[[int], None] = lambda _cases: None
    result: Callable[[CaseResult], None] = lambda _result: None


def judge(
    submission: Submission,
    problem: Problem,
    options: Options | None = None,
    *,
    events: Events | None = None,
    executor: Executor | None = None,
) -> Judging:
    """Judge `submission` and return all results.

    executor: where the runs are made, `options.jobs` at a time; threads if None.
    Raises CasesError, LanguageError, SandboxError or JudgeError when nothing can
    be judged; whatever happens to a single run ends as that case's JE. On any
    exception, Ctrl-C included, no process and no file is left.
    """
    options, events = options or Options(), events or Events()
    all_cases, cases = _chosen(problem, options)
    wall = _wall_for(submission, problem, options)
    with Sandbox(wall) as sandbox:
        scale = options.scale
        if scale is None and options.time_limit_s is None:
            events.phase("timing the reference solution")
            scale = machine_scale(problem, sandbox)
        declared_s = problem.limits.time_limit_s
        limit_s = options.time_limit_s or declared_s * (scale or 1.0)
        limits = RunLimits(limit_s, problem.limits.memory_mib, problem.limits.output_mib)
        outcome = Judging(
            submission=printable_name(submission.name),
            language=submission.language.name,
            verdict=Verdict.AC,
            score=0,
            max_score=problem.max_score,
            partial=options.data != DATA or len(cases) < len(all_cases),
            time_limit_s=limit_s,
            declared_s=declared_s,
            memory_mib=limits.memory_mib,
            scale=scale,
            groups=(),
            wall=None if wall is None else str(wall),
        )
        events.phase(f"compiling {outcome.submission} ({submission.language.name})")
        try:
            program = compile_submission(submission, problem.limits, sandbox)
        except CompileError as error:
            left_out = [not_run(case, "does not compile") for case in cases]
            groups = tuple(
                replace(group, verdict=Verdict.CE, score=0)
                for group in group_results(problem, all_cases, left_out)
            )
            return replace(outcome, verdict=Verdict.CE, groups=groups, message=str(error))
        events.start(len(cases))
        results = []
        own = ThreadPoolExecutor(options.jobs)  # starts no thread that is not used
        try:
            runs = Runs(
                sandbox,
                program,
                limits,
                executor or own,
                jobs=options.jobs,
                stop_on_first=options.stop_on_first,
            )
            for result in runs.in_order(cases):
                events.result(result)
                results.append(result)
        except BaseException:
            sandbox.close()  # ends the runs, so that their threads end too
            raise
        finally:
            own.shutdown(cancel_futures=True)
        groups = group_results(problem, all_cases, results)
        return replace(
            outcome,
            verdict=first_failure(group.verdict for group in groups),
            score=sum(group.score for group in groups),
            groups=groups,
        )


def _chosen(problem: Problem, options: Options) -> tuple[list[Case], list[Case]]:
    """Return all cases of the data, and the chosen ones, held to the manifest."""
    manifest = load_manifest(options.data)
    all_cases = find_cases(options.data, problem)
    if options.data == DATA:
        wanted = options.groups or problem.group_names
        check_built(all_cases, [g for g in problem.group_names if g in wanted], options.data)
        check_complete(manifest, all_cases, wanted)
    cases = select(all_cases, options.groups, options.globs)
    check_sums(manifest, cases)
    return all_cases, cases


def _wall_for(submission: Submission, problem: Problem, options: Options) -> Wall | None:
    """Return the wall that stands; None only for code that is trusted or explicitly allowed.

    The kit vouches for its reference, brute force and declared submissions.
    """
    found = probe()
    if found.wall is not None or options.no_wall:
        return found.wall
    vouched = {REFERENCE, ROOT / "brute.py", *(SUBMISSIONS / name for name in problem.submissions)}
    if Path(submission.name).resolve() in vouched:
        return None
    raise JudgeError(
        f"no wall stands ({found.why}), so {submission.name} could read, change and send "
        "whatever you can; if you trust it, say --no-wall"
    )


def machine_scale(problem: Problem, sandbox: Sandbox) -> float | None:
    """Return how many times slower than the calibrating machine this one is, at least 1.

    None when the calibration case is not built. Raises JudgeError as `reference_cpu_s`.
    """
    declared_s = problem.calibration.reference_cpu_s
    if not calibration_case(problem).input.is_file():
        return None
    return max(1.0, reference_cpu_s(problem, sandbox, SCALE_RUNS, enough_s=declared_s) / declared_s)


def calibration_case(problem: Problem) -> Case:
    """Return the case that machines are compared on; it may not be built."""
    name = problem.calibration.case
    stem = DATA / name
    return Case(name, "", stem.with_name(stem.name + ".in"), stem.with_name(stem.name + ".ans"))


def reference_cpu_s(problem: Problem, sandbox: Sandbox, runs: int, enough_s: float = 0.0) -> float:
    """Return the CPU seconds of the reference on the calibration case: the least of `runs`.

    The least, as what disturbs a measurement only ever adds to it; no more runs than it
    takes to stay within `enough_s`. Raises JudgeError if the reference fails.
    """
    case = calibration_case(problem)
    check_sums(load_manifest(DATA), [case])
    try:
        reference = compile_submission(read_submission(REFERENCE), problem.limits, sandbox)
    except CompileError as error:
        raise JudgeError(f"the reference does not compile: {error}") from None
    limits = RunLimits(
        problem.calibration.reference_cpu_s * CALIBRATION_LIMIT_FACTOR,
        problem.limits.memory_mib,
        problem.limits.output_mib,
    )
    least_s = limits.time_limit_s
    for _ in range(runs):
        result = run_case(sandbox, reference.command, limits, case)
        if result.verdict is not Verdict.AC:
            raise JudgeError(
                f"the reference is not accepted on {case.name}: {result.verdict} {result.message}"
            )
        least_s = min(least_s, result.cpu_s)
        if least_s <= enough_s:
            break
    return least_s
