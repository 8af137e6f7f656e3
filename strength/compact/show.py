"""What the small selection of cases costs in strength and saves in size and time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from rich.console import Console
from rich.table import Table
from rich.text import Text

from judge.kit.paths import REFERENCE
from judge.kit.text import counted
from judge.languages.submission import compile_submission, read_submission
from judge.problem.cases import Case
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from judge.run import run_case
from judge.sandbox.facts import RunLimits
from judge.sandbox.sandbox import Sandbox, SandboxError
from strength.analysis import FEWEST_KILLS
from strength.compact.choose import FEWEST_SLOW, kills, wanted
from strength.table import Matrix

MIB = 1 << 20
Chosen = Mapping[str, Sequence[str]]  # names of cases by group


def reference_seconds(cases: Sequence[Case], problem: Problem, scale: float) -> dict[str, float]:
    """Run the reference on every case; return the CPU seconds by case. Raises SandboxError."""
    declared = problem.limits
    limits = RunLimits(declared.time_limit_s * scale, declared.memory_mib, declared.output_mib)
    seconds: dict[str, float] = {}
    with Sandbox() as sandbox:
        program = compile_submission(read_submission(REFERENCE), declared, sandbox)
        for case in cases:
            result = run_case(sandbox, program, limits, case)
            if result.verdict is not Verdict.AC:
                raise SandboxError(f"{REFERENCE.name}: expected AC on {case.name}")
            seconds[case.name] = result.cpu_s
    return seconds


def print_cost(
    console: Console, matrix: Matrix, problem: Problem, chosen: Chosen, seconds: Mapping[str, float]
) -> None:
    """Print cases, MiB, time and strength of the selection, group by group, and in all."""
    table = Table(show_edge=False, pad_edge=False)
    table.add_column("group", no_wrap=True)
    for title in (
        "cases",
        "MiB",
        "reference, CPU s",
        f"wrong ones with {FEWEST_KILLS}+ killers",
        f"slow ones with {FEWEST_SLOW}+",
    ):
        table.add_column(title, justify="right", no_wrap=True)
    kept = {name for names in chosen.values() for name in names}
    for group in chosen:
        table.add_row(group, *_row(matrix, problem, [group], kept, seconds))
    table.add_section()
    table.add_row("all", *_row(matrix, problem, list(chosen), kept, seconds))
    console.print(table)
    whole = sum(seconds.values())
    share = sum(seconds[name] for name in kept) / whole
    console.print(f"the reference takes {share:.0%} of its CPU time on all cases")
    for line in weak(matrix, problem, list(chosen), kept):
        console.print(Text(line, style="dim"), soft_wrap=True)


def _row(
    matrix: Matrix,
    problem: Problem,
    groups: Sequence[str],
    kept: set[str],
    seconds: Mapping[str, float],
) -> Iterator[str]:
    cases = [case for case in matrix.cases if case.group in groups]
    some = [case for case in cases if case.name in kept]
    yield f"{len(some)} of {len(cases)}"
    yield f"{_mib(some):.1f} of {_mib(cases):.1f}"
    yield f"{sum(seconds[c.name] for c in some):.1f} of {sum(seconds[c.name] for c in cases):.1f}"
    for want in (FEWEST_KILLS, FEWEST_SLOW):
        demands = [
            demand
            for group in groups
            for demand in kills(matrix, problem, group)
            if wanted(problem, demand.submission, group) == want
        ]
        strong = sum(len(demand.cases & kept) >= want for demand in demands)
        yield f"{strong} of {len(demands)}"


def _mib(cases: Sequence[Case]) -> float:
    return sum(c.input.stat().st_size + c.answer.stat().st_size for c in cases) / MIB


def weak(matrix: Matrix, problem: Problem, groups: Sequence[str], kept: set[str]) -> Iterator[str]:
    """Yield a line for each submission that fewer cases of a group kill than wanted, and why."""
    rows = {row.submission: row.verdicts for row in matrix.rows}
    for group in groups:
        names = [case.name for case in matrix.cases if case.group == group]
        for demand in kills(matrix, problem, group):
            count = len(demand.cases & kept)
            if count >= wanted(problem, demand.submission, group):
                continue
            missing = sum(name not in rows[demand.submission] for name in names)
            why = f"all {len(demand.cases)} that are known"
            if missing:
                why += f"; {counted(missing, 'case')} not run after a TLE"
            yield f"{demand.submission}: {group}: {counted(count, 'killer')}, {why}"
