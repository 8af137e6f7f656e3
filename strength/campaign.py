"""Every mutant tried on the data: what was killed, and what was not.

A driver of our own, because the kept ones (cosmic-ray, mutmut) run a test suite against
an importable package, one process per mutant; here the program is a stdin-to-stdout
script, the tests are files, and 1,000 mutants share one interpreter's start.
"""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path

from gen.rng import Rng
from judge.kit.errors import KitError
from judge.kit.paths import ROOT
from judge.problem.cases import Case
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from strength.equivalents import Entry, entry_of, unused
from strength.mutate import Mutant, mutants
from strength.trial import Kill, Trial, first_kill

LIGHT_VERTICES = 2_000  # groups whose files are at most so large are tried first
LIGHT_LIMIT_S = 2.0  # 100 times what the originals take: what is over it does not end
HEAVY_FACTOR = 3.0  # of the declared limit: a busy machine must not fail the originals
REFERENCE = "solution.py"
SUBMISSIONS = "submissions/"
ACCEPTED = "accepted/"


class CampaignError(KitError):
    """Nothing can be learnt: an unchanged program fails; one clear line."""


@dataclass(frozen=True, slots=True)
class Finding:
    """What came of one mutant: the kill or None, and the entry that calls it equivalent."""

    mutant: Mutant
    kill: Kill | None
    entry: Entry | None

    @property
    def stale(self) -> bool:
        """Called equivalent one by one, but killed."""
        return self.kill is not None and self.entry is not None and not self.entry.whole_line

    @property
    def survived(self) -> bool:
        """Neither killed nor called equivalent."""
        return self.kill is None and self.entry is None


@dataclass(frozen=True, slots=True)
class Campaign:
    """All findings in order of the mutants, and the entries that name no mutant."""

    findings: tuple[Finding, ...]
    unused: tuple[str, ...]

    @property
    def ok(self) -> bool:
        """Whether every mutant is killed or proved equivalent, and the list is true."""
        return not self.unused and not any(f.survived or f.stale for f in self.findings)


@dataclass(frozen=True, slots=True)
class Plan:
    """One program and what it is tried on: `light` cases first, `heavy` for what survives."""

    program: str
    light: tuple[Trial, ...]
    heavy: tuple[Trial, ...]


def programs(problem: Problem) -> list[str]:
    """Return the reference and the declared Python programs that are right, by path."""
    accepted = [f"{SUBMISSIONS}{name}" for name in problem.submissions if name.startswith(ACCEPTED)]
    return [REFERENCE, *sorted(path for path in accepted if path.endswith(".py"))]


def plan_for(program: str, cases: Sequence[Case], problem: Problem, *, heavy: bool) -> Plan:
    """Choose the cases of the groups in which the program is expected to be accepted."""
    light: list[Trial] = []
    rest: list[Trial] = []
    for case in cases:
        if not _passes(program, case.group, problem):
            continue
        most = problem.group(case.group).max_vertices
        is_light = most is not None and most <= LIGHT_VERTICES
        (light if is_light else rest).append(Trial(case.name, case.input, case.answer))
    return Plan(program, tuple(light), tuple(rest) if heavy else ())


def _passes(program: str, group: str, problem: Problem) -> bool:
    if program == REFERENCE:
        return True
    return problem.expected(program.removeprefix(SUBMISSIONS), group) == {Verdict.AC}


def sample(every: Sequence[Mutant], size: int, seed: int) -> list[Mutant]:
    """Return `size` of the mutants, or all if there are fewer; equal seeds, equal choice."""
    return Rng(seed).subset(every, min(size, len(every)))


def run(
    plans: Sequence[Plan],
    entries: Sequence[Entry],
    problem: Problem,
    *,
    jobs: int,
    quick: int | None = None,
    seed: int = 1,
    thorough: bool = False,
    root: Path = ROOT,
    start: Callable[[int], None] = lambda _mutants: None,
    done: Callable[[Finding], None] = lambda _finding: None,
) -> Campaign:
    """Try all mutants of all programs, or `quick` of them, in `jobs` processes.

    What is called equivalent is tried on the light cases only, unless thorough. Raises
    CampaignError if an unchanged program fails a case.
    """
    limits = HEAVY_FACTOR * problem.limits.time_limit_s, problem.limits.memory_mib
    by_program = {plan.program: plan for plan in plans}
    every: list[Mutant] = []
    # Workers fork children themselves, so they are fresh processes without threads.
    with ProcessPoolExecutor(jobs, multiprocessing.get_context("spawn")) as pool:
        originals = {}
        for plan in plans:
            content = (root / plan.program).read_bytes()
            every += mutants(plan.program, content)
            originals[plan.program] = pool.submit(
                first_kill, content, plan.light + plan.heavy, *limits
            )
        for program, trial in originals.items():
            if kill := trial.result():
                raise CampaignError(
                    f"{program}: expected AC on {kill.case} as it is, found {kill.verdict}"
                )
        chosen = every if quick is None else sample(every, quick, seed)
        start(len(chosen))
        numbers = {}
        for number, mutant in enumerate(chosen):
            plan = by_program[mutant.program]
            heavy = plan.heavy if thorough or not entry_of(mutant, entries) else ()
            future = pool.submit(_kill, mutant.source, plan.light, heavy, *limits)
            numbers[future] = number
        findings: dict[int, Finding] = {}
        try:
            for future in as_completed(numbers):
                mutant = chosen[numbers[future]]
                finding = Finding(mutant, future.result(), entry_of(mutant, entries))
                findings[numbers[future]] = finding
                done(finding)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    considered = [entry for entry in entries if entry.program in by_program]
    return Campaign(
        tuple(findings[number] for number in range(len(chosen))),
        tuple(unused(considered, every)),
    )


def _kill(
    source: bytes,
    light: Sequence[Trial],
    heavy: Sequence[Trial],
    time_limit_s: float,
    memory_mib: int,
) -> Kill | None:
    """In a worker: try one mutant; the heavy cases only if it survives the light ones."""
    light_limit_s = min(LIGHT_LIMIT_S, time_limit_s)
    kill = first_kill(source, light, light_limit_s, memory_mib) if light else None
    if kill is None and heavy:
        kill = first_kill(source, heavy, time_limit_s, memory_mib)
    return kill
