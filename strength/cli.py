"""The strength of the data: `python -m strength`, `python -m strength mutants`.

The first is the kill matrix: all declared submissions on all test cases. The second has a
room of its own, `strength.mutants`.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from pathlib import Path

from judge.kit.command import Parser, add_jobs, run
from judge.kit.console import PlainConsole
from judge.kit.files import check_place, write_report
from judge.kit.processors import processors
from judge.kit.progress import progress_bar
from judge.kit.store import Store
from judge.kit.text import counted, did_you_mean
from judge.languages.submission import SubmissionError
from judge.machine import scale_of
from judge.problem.data import Data, load_data
from judge.problem.declaration import Problem, load
from judge.problem.order import save_order
from judge.sandbox.sandbox import Sandbox
from strength.analysis import Analysis, analyse
from strength.compact import command as compact
from strength.compact.slow import further_runs
from strength.gallery import cli as gallery
from strength.mutants import cli as mutants
from strength.order import telling_order
from strength.page import page
from strength.show import as_json, print_cases, print_findings, print_groups
from strength.table import Further, Matrix, build, nothing_further

AS_DECLARED, FAULTS = 0, 1


def main(arguments: Sequence[str]) -> int:
    """Run the command line; return its exit status: 0 strong, 1 not, 2 failed."""

    def command() -> int:
        if arguments[:1] == ["gallery"]:
            return gallery.command(arguments[1:])
        if arguments[:1] == ["mutants"]:
            return mutants.command(arguments[1:])
        return _matrix_command(arguments)

    return run("strength", command)


def _matrix_command(arguments: Sequence[str]) -> int:
    """Return 0 if all submissions are judged as declared, else 1. Raises KitError, OSError."""
    parser = Parser(
        prog="python -m strength",
        description="Judge every declared submission on every test case, and tell what the "
        "cases are good for. In a group, nothing is run after a first TLE. Verdicts are kept, "
        "so that only what changed runs again. Another command: python -m strength mutants.",
    )
    add = parser.add_argument
    add("submission", nargs="*", help="path below submissions/ (default: all)")
    add("--groups", default="", help="comma-separated (default: all)")
    add("--cases", action="store_true", help="print every verdict, case by case")
    add("--json", type=Path, metavar="FILE", help="write everything as JSON")
    add("--html", type=Path, metavar="FILE", help="write one page of tables")
    add("--order", action="store_true", help="write data/order.json, the order of judging")
    add("--compact", action="store_true", help="write data/compact.json, a small selection")
    add_jobs(parser, processors(), "submissions judged")
    options = parser.parse_args(arguments)
    check_place("--json", options.json)
    check_place("--html", options.html)
    start = time.perf_counter()
    problem = load()
    known = list(problem.submissions)
    for name in options.submission:
        if name not in known:
            near = did_you_mean(name, known)
            raise SubmissionError(f"{name}: problem.toml declares no such submission{near}")
    for option, wanted in (("--order", options.order), ("--compact", options.compact)):
        if wanted and (options.submission or options.groups):
            raise SubmissionError(f"{option}: expected all submissions and groups, found only some")
    groups = [word for word in options.groups.split(",") if word] or problem.group_names
    with Store() as store:
        data = load_data(problem, groups=groups, store=store)
        further = further_runs(data, problem) if options.compact else nothing_further
        matrix = _judged(options.submission or known, data, problem, store, options.jobs, further)
    families = {name: entry.family for name, entry in data.manifest.cases.items()}
    analysis = analyse(matrix, problem, families)
    _print(matrix, analysis, time.perf_counter() - start, cases=options.cases)
    write_report("--json", options.json, lambda: as_json(matrix, analysis))
    write_report("--html", options.html, lambda: page(matrix, analysis, families).encode())
    if options.order:
        sizes = {case.name: case.input.stat().st_size for case in matrix.cases}
        save_order(data.directory, telling_order(matrix, sizes))
    if options.compact:
        compact.write(matrix, data, problem)
    return FAULTS if analysis.faults else AS_DECLARED


def _judged(
    submissions: Sequence[str],
    data: Data,
    problem: Problem,
    store: Store,
    jobs: int,
    further: Further,
) -> Matrix:
    total = len(submissions) * len(data.chosen)
    with Sandbox() as sandbox, progress_bar("timing the reference solution", total) as bar:

        def done(submission: str) -> None:
            bar.say(submission)
            bar.advance()

        scale = scale_of(problem, sandbox)
        return build(
            submissions,
            data,
            problem,
            sandbox,
            store,
            scale=scale,
            jobs=jobs,
            done=done,
            further=further,
        )


def _print(matrix: Matrix, analysis: Analysis, seconds: float, *, cases: bool) -> None:
    console = PlainConsole()
    print_groups(console, analysis)
    if cases:
        print_cases(console, matrix)
    print_findings(console, matrix, analysis, needless=cases)
    console.print(
        f"{counted(len(matrix.rows), 'submission')}, {counted(len(matrix.cases), 'case')}: "
        f"{counted(matrix.judged, 'run')} made, the others kept from before; {seconds:.0f} s"
    )
