"""`python -m strength`: the kill matrix of all declared submissions on all test cases."""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Sequence
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

from gen.manifest import ManifestError
from gen.manifest import load as load_generated
from judge.judging import JudgeError, machine_scale
from judge.kit.files import write_whole
from judge.kit.paths import DATA
from judge.kit.text import did_you_mean
from judge.languages.submission import SubmissionError
from judge.languages.table import LanguageError
from judge.problem.cases import CasesError, check_built, find_cases, select
from judge.problem.declaration import Problem, SpecError, load
from judge.problem.manifest import check_complete, check_sums, load_manifest
from judge.sandbox.facts import RunLimits
from judge.sandbox.sandbox import Sandbox, SandboxError
from strength.analysis import Analysis, analyse
from strength.page import page
from strength.show import as_json, print_cases, print_findings, print_groups
from strength.table import Matrix, build

FILE_WIDTH = 160  # of the table when it is not printed to a terminal
ERRORS = (
    CasesError,
    JudgeError,
    LanguageError,
    ManifestError,
    SandboxError,
    SpecError,
    SubmissionError,
)


def main(arguments: Sequence[str]) -> int:
    """Run the command; return 0 if every submission falls as it must, else 1; 2 failed.

    Raises ERRORS, OSError, KeyboardInterrupt.
    """
    parser = argparse.ArgumentParser(
        prog="python -m strength",
        description="Judge every declared submission on every test case, and tell what the "
        "cases are good for. In a group, nothing is run after a first TLE. Verdicts are kept, "
        "so that only what changed runs again. Another command: python -m strength mutants.",
    )
    parser.add_argument("submission", nargs="*", help="path below submissions/ (default: all)")
    parser.add_argument("--groups", default="", help="comma-separated (default: all)")
    parser.add_argument("--cases", action="store_true", help="print every verdict, case by case")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write everything as JSON")
    parser.add_argument("--html", type=Path, metavar="FILE", help="write one page of tables")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    options = parser.parse_args(arguments)
    start = time.perf_counter()
    problem = load()
    families = {name: entry.family for name, entry in load_generated(DATA).cases.items()}
    matrix = _matrix(options, problem)
    analysis = analyse(matrix, problem, families)
    _print(matrix, analysis, time.perf_counter() - start, cases=options.cases)
    if options.json:
        write_whole(options.json, as_json(matrix, analysis), parents=True)
    if options.html:
        write_whole(options.html, page(matrix, analysis, families).encode(), parents=True)
    return 1 if analysis.faults else 0


def _matrix(options: argparse.Namespace, problem: Problem) -> Matrix:
    known = list(problem.submissions)
    for name in options.submission:
        if name not in known:
            near = did_you_mean(name, known)
            raise SubmissionError(f"{name}: problem.toml declares no such submission{near}")
    wanted = [word for word in options.groups.split(",") if word] or problem.group_names
    all_cases = find_cases(DATA, problem)
    check_built(all_cases, [group for group in problem.group_names if group in wanted], DATA)
    manifest = load_manifest(DATA)
    check_complete(manifest, all_cases, wanted)
    cases = select(all_cases, wanted, ())
    check_sums(manifest, cases)
    names = options.submission or known
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
    )
    console = Console(stderr=True)
    with Sandbox() as sandbox, Progress(*columns, console=console, transient=True) as progress:
        task = progress.add_task("timing the reference solution", total=len(names) * len(cases))
        scale = machine_scale(problem, sandbox) or 1.0
        limits = RunLimits(
            problem.limits.time_limit_s, problem.limits.memory_mib, problem.limits.output_mib
        )

        def done(submission: str, _number: int) -> None:
            progress.update(task, description=submission, advance=1)

        return build(
            names, cases, problem, limits, sandbox, scale=scale, jobs=options.jobs, done=done
        )


def _print(matrix: Matrix, analysis: Analysis, seconds: float, *, cases: bool) -> None:
    console = Console()
    if not console.is_terminal:
        console.width = FILE_WIDTH
    print_groups(console, analysis)
    if cases:
        print_cases(console, matrix)
    print_findings(console, matrix, analysis, needless=cases)
    console.print(
        f"{len(matrix.rows)} submissions, {len(matrix.cases)} cases: {matrix.judged} runs made, "
        f"the others kept from before; {seconds:.0f} s"
    )
