"""Judges a whole class: reads the hand-ins, judges each program once, writes the reports."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Sequence
from contextlib import ExitStack, closing
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from rich.console import Console
from rich.text import Text

from judge.batch.board import Board
from judge.batch.entries import ClassError, entries_of
from judge.batch.kept import KeptOutcomes
from judge.batch.layouts import hand_ins
from judge.batch.outcome import Outcome
from judge.batch.reports import JsonLines, to_csv, to_page
from judge.batch.rows import Row, notes, row_of
from judge.batch.tasks import Executors, Task, outcomes
from judge.batch.workers import judge_here, local_workers
from judge.diagnosis.gallery import load_gallery
from judge.judging import JudgeError, Options
from judge.kit.files import write_report
from judge.kit.progress import progress_bar
from judge.kit.store import Store
from judge.kit.text import counted, printable_name
from judge.languages.table import Language
from judge.machine import kept_scale, measure_scale
from judge.problem.data import load_data
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from judge.reports.terminal import verdict_text
from judge.results import Scale
from judge.sandbox.probe import NoWallError, walled_sandbox


@dataclass(frozen=True, slots=True)
class Places:
    """Where the reports go; None: nowhere."""

    csv: Path | None = None
    html: Path | None = None
    json: Path | None = None


def judge_class(
    path: Path,
    problem: Problem,
    options: Options,
    places: Places,
    language: Language | None,
    console: Console,
    *,
    executors: Executors | None = None,
    work: Callable[[Task], Outcome] = judge_here,
) -> list[Row]:
    """Judge all hand-ins of a directory or zip; return a row for each, in order.

    options.jobs programs are judged at once. executors, work: what carries out the tasks, and
    what they are; None: processes of this machine. What was judged by an earlier call is not
    judged again. Raises KitError if nothing can be judged.
    """
    started = time.monotonic()
    rows = read_class(path, problem, language)
    make = executors or partial(local_workers, options.jobs)
    with ExitStack() as stack:
        store = stack.enter_context(Store())
        data = load_data(
            problem, options.data, options.groups, options.globs, store, compact=options.compact
        )
        others = (path.absolute(),) if path.is_dir() else ()
        each = replace(options, jobs=1, scale=_scale(problem, options), hidden=others)
        kept = KeptOutcomes(store, problem, each, data)
        lines = None if places.json is None else JsonLines("--json", places.json)
        board = Board(rows, console, None if lines is None else stack.enter_context(lines))
        bar = stack.enter_context(progress_bar("judging", console=console, forecast=True))
        tasks = board.tasks(kept, problem, each)
        bar.begin(len(tasks))
        running = stack.enter_context(closing(outcomes(tasks, make, options.jobs, work)))
        begun = time.monotonic()
        for done, (number, outcome) in enumerate(running, 1):
            kept.keep(tasks[number], outcome)
            board.judged(tasks[number].submission, outcome)
            bar.advance()
            bar.say(f"judging, {60 * done / (time.monotonic() - begun):.1f} a minute")
    lessons = {name: lesson.sentence for name, lesson in load_gallery().lessons.items()}
    title = printable_name(path.absolute().name)
    write_report("--csv", places.csv, lambda: to_csv(board.rows, problem))
    write_report("--html", places.html, lambda: to_page(board.rows, problem, title, lessons))
    _print_end(console, board.rows, len(tasks), time.monotonic() - started)
    return board.rows


def read_class(path: Path, problem: Problem, language: Language | None) -> list[Row]:
    """Return a row for each hand-in, not yet judged. Raises ClassError."""
    with entries_of(path) as entries:
        rows = [row_of(each, problem.limits, language) for each in hand_ins(entries)]
    if not rows:
        raise ClassError(f"{path}: expected hand-ins, found no files")
    return [replace(row, note=note) for row, note in zip(rows, notes(rows), strict=True)]


def _scale(problem: Problem, options: Options) -> Scale | None:
    """Return one scale for all, measured if it is not kept, while nothing else runs.

    Raises JudgeError where no wall works.
    """
    try:
        with walled_sandbox(without_wall=options.no_wall) as sandbox:
            if options.time_limit_s is not None:
                return None
            return kept_scale(problem) or measure_scale(problem, sandbox)
    except NoWallError as error:
        raise JudgeError(
            f"no wall works here ({error}), so the programs could read, change and send whatever "
            "you can; if you trust them all, say --no-wall"
        ) from None


def _print_end(console: Console, rows: Sequence[Row], runs: int, seconds: float) -> None:
    """Print the summary: verdicts, lessons missed by how many, how long it took."""
    judged = [row.outcome for row in rows if row.outcome is not None]
    verdicts = Counter(outcome.verdict for outcome in judged)
    for verdict, many in verdicts.most_common():
        console.print(verdict_text(verdict, width=4).append(f" {many:>5}"))
    missed = Counter(lesson for outcome in judged for lesson in outcome.lessons)
    for lesson, many in missed.most_common():
        console.print(Text(f"{many:>5}  missed {lesson}", style="dim"))
    if alike := sum(bool(row.note) for row in rows):
        console.print(Text(f"identical or nearly identical to others: {alike}, see the notes"))
    if any(outcome.wall is None and outcome.verdict is not Verdict.JE for outcome in judged):
        console.print(Text("there was no wall around some of the programs", style="yellow"))
    if any(outcome.partial for outcome in judged):
        console.print(Text("partial: not all of the kit's cases were chosen", style="yellow"))
    rate = f", {runs / seconds * 60:.1f} a minute" if runs else ""
    parts = [
        f"{counted(len(rows), 'hand-in')}: {counted(runs, 'program')} judged in {seconds:.0f} s"
    ]
    before = sum(row.kept for row in rows)
    parts += [f"{counted(before, 'hand-in')} judged before"] if before else []
    parts += [f"{len(rows) - len(judged)} not judged"] if len(judged) < len(rows) else []
    console.print("; ".join([parts[0] + rate, *parts[1:]]))
