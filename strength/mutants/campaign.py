"""Every mutant tried on the data: which ones it kills, and which ones survive.

This is our own driver because the well-known ones (cosmic-ray, mutmut) run a test suite
against an importable package, one process per mutant. Here a program reads standard input,
the tests are files, and 1,000 mutants share one start of the interpreter.
"""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Sequence
from concurrent.futures import BrokenExecutor, ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path

from gen.rng import Rng
from judge.kit.errors import KitError
from judge.kit.paths import REFERENCE, ROOT
from judge.problem.cases import Case
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from strength.mutants.equivalents import Equivalent, equivalent_of, unused
from strength.mutants.mutate import Mutant, mutants
from strength.mutants.trial import Kill, first_kill

LIGHT_VERTICES = 2_000  # groups whose files have at most so many are tried first
LIGHT_LIMIT_S = 2.0  # 100 times what the originals take: a longer run will not end
HEAVY_FACTOR = 3.0  # of the declared limit, so that the originals pass on a busy machine
SUBMISSIONS = "submissions/"
ACCEPTED = "accepted/"


class CampaignError(KitError):
    """Nothing can be learnt: an unchanged program fails, or a worker died."""


@dataclass(frozen=True, slots=True)
class Finding:
    """The result of one mutant: what killed it, and what lists it as equivalent, if anything."""

    mutant: Mutant
    kill: Kill | None
    equivalent: Equivalent | None

    @property
    def stale(self) -> bool:
        """Whether it is killed though it is listed as equivalent, and not with its whole line."""
        if self.kill is None or self.equivalent is None:
            return False
        return not self.equivalent.whole_line

    @property
    def survived(self) -> bool:
        """Whether it is neither killed nor listed as equivalent."""
        return self.kill is None and self.equivalent is None


@dataclass(frozen=True, slots=True)
class Campaign:
    """All findings in the order of the mutants, and the listed changes that are no mutants."""

    findings: tuple[Finding, ...]
    unused: tuple[str, ...]

    @property
    def ok(self) -> bool:
        """Whether every mutant is killed or proved equivalent, and the list has no errors."""
        return not self.unused and not any(f.survived or f.stale for f in self.findings)


@dataclass(frozen=True, slots=True)
class Plan:
    """One program and its cases: the `light` ones first, the `heavy` ones for survivors."""

    program: str
    light: tuple[Case, ...]
    heavy: tuple[Case, ...]


def light_groups(problem: Problem) -> list[str]:
    """Return the groups of small files."""
    return [
        group.name
        for group in problem.groups
        if group.max_vertices is not None and group.max_vertices <= LIGHT_VERTICES
    ]


def programs(problem: Problem) -> list[str]:
    """Return the paths of the reference and of all Python programs declared accepted."""
    accepted = [f"{SUBMISSIONS}{name}" for name in problem.submissions if name.startswith(ACCEPTED)]
    return [REFERENCE.name, *sorted(path for path in accepted if path.endswith(".py"))]


def plan_for(program: str, cases: Sequence[Case], problem: Problem, *, heavy: bool) -> Plan:
    """Choose the cases of the groups in which the program is expected to be accepted."""
    passed = [case for case in cases if _passes(program, case.group, problem)]
    groups = light_groups(problem)
    light = tuple(case for case in passed if case.group in groups)
    rest = tuple(case for case in passed if case.group not in groups)
    return Plan(program, light, rest if heavy else ())


def _passes(program: str, group: str, problem: Problem) -> bool:
    if program == REFERENCE.name:
        return True
    return problem.expected(program.removeprefix(SUBMISSIONS), group) == {Verdict.AC}


def sample(every: Sequence[Mutant], size: int, seed: int) -> list[Mutant]:
    """Return `size` of the mutants, or all if there are fewer; equal seeds, equal choice."""
    return Rng(seed).subset(every, min(size, len(every)))


def run(
    plans: Sequence[Plan],
    equivalents: Sequence[Equivalent],
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

    Mutants listed as equivalent are tried on the light cases only, unless thorough. start:
    called with the number of mutants, done: with each finding. Raises CampaignError if an
    unchanged program fails a case, or if a worker dies.
    """
    # Workers fork children themselves, so they are fresh processes without threads.
    with ProcessPoolExecutor(jobs, multiprocessing.get_context("spawn")) as pool:
        try:
            every = _mutants_of_passing(plans, problem, root, pool)
            chosen = every if quick is None else sample(every, quick, seed)
            start(len(chosen))
            limits = _limits(problem)
            by_program = {plan.program: plan for plan in plans}
            numbers = {}
            for number, mutant in enumerate(chosen):
                plan = by_program[mutant.program]
                heavy = plan.heavy if thorough or not equivalent_of(mutant, equivalents) else ()
                future = pool.submit(_kill, mutant.source, plan.light, heavy, *limits)
                numbers[future] = number
            findings: dict[int, Finding] = {}
            for future in as_completed(numbers):
                mutant = chosen[numbers[future]]
                finding = Finding(mutant, future.result(), equivalent_of(mutant, equivalents))
                findings[numbers[future]] = finding
                done(finding)
        except BrokenExecutor as error:
            raise CampaignError(f"a mutant could not be tried: {error}") from None
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    considered = [one for one in equivalents if one.program in by_program]
    return Campaign(
        tuple(findings[number] for number in range(len(chosen))),
        tuple(unused(considered, every)),
    )


def _mutants_of_passing(
    plans: Sequence[Plan], problem: Problem, root: Path, pool: ProcessPoolExecutor
) -> list[Mutant]:
    """Return all mutants. Raises CampaignError if an unchanged program fails a case."""
    contents = {plan.program: (root / plan.program).read_bytes() for plan in plans}
    originals = {
        plan.program: pool.submit(
            first_kill, contents[plan.program], plan.light + plan.heavy, *_limits(problem)
        )
        for plan in plans
    }
    for program, future in originals.items():
        if kill := future.result():
            raise CampaignError(
                f"{program}: expected AC on {kill.case} as it is, found {kill.verdict}"
            )
    return [mutant for program, text in contents.items() for mutant in mutants(program, text)]


def _limits(problem: Problem) -> tuple[float, int]:
    """Return the limits of a run on a heavy case: CPU seconds, and MiB of address space."""
    return HEAVY_FACTOR * problem.limits.time_limit_s, problem.limits.memory_mib


def _kill(
    source: bytes,
    light: Sequence[Case],
    heavy: Sequence[Case],
    time_limit_s: float,
    memory_mib: int,
) -> Kill | None:
    """In a worker: try one mutant on the light cases, and if it survives on the heavy ones."""
    light_limit_s = min(LIGHT_LIMIT_S, time_limit_s)
    kill = first_kill(source, light, light_limit_s, memory_mib) if light else None
    if kill is None and heavy:
        kill = first_kill(source, heavy, time_limit_s, memory_mib)
    return kill
