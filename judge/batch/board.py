"""The rows of a class while they fill: each is printed and written as soon as it is known."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rich.console import Console
from rich.text import Text

from judge.batch.kept import KeptOutcomes
from judge.batch.outcome import Outcome, judge_error
from judge.batch.reports import JsonLines
from judge.batch.rows import Row, diagnosis, failure, key_of
from judge.batch.tasks import Task
from judge.judging import Options
from judge.languages.submission import Submission
from judge.languages.table import LanguageError
from judge.languages.toolchain import toolchain
from judge.problem.declaration import Problem
from judge.reports.terminal import verdict_text


class Board:
    """The rows of a class. lines: where each filled row is written, None: nowhere."""

    def __init__(self, rows: Sequence[Row], console: Console, lines: JsonLines | None) -> None:
        self.rows = list(rows)
        self._console, self._lines = console, lines
        self._filled = 0
        self._places: dict[str, list[int]] = {}  # of the rows with the same program
        for number, row in enumerate(rows):
            if row.submission is not None:
                self._places.setdefault(key_of(row.submission), []).append(number)

    def tasks(self, kept: KeptOutcomes, problem: Problem, options: Options) -> list[Task]:
        """Fill the rows that need no run, and return a task for each program that does."""
        for number, row in enumerate(self.rows):
            if row.submission is None:
                self._fill(number, row)
        programs = {key: self._program(places) for key, places in self._places.items()}
        found = kept.look_up(programs)
        for key, outcome in found.items():
            self.judged(programs[key], outcome, kept=True)
        tasks = []
        missing: dict[str, str] = {}
        for program in (program for key, program in programs.items() if key not in found):
            name = program.language.name
            if name not in missing:
                missing[name] = _missing_tool(program)
            if missing[name]:
                self.judged(program, judge_error(missing[name], problem.max_score))
            else:
                tasks.append(Task(program, problem, options))
        return tasks

    def judged(self, program: Submission, outcome: Outcome, *, kept: bool = False) -> None:
        """Fill all rows with this program. kept: the outcome is of an earlier judging."""
        for number in self._places[key_of(program)]:
            self._fill(number, replace(self.rows[number], outcome=outcome, kept=kept))

    def _program(self, places: Sequence[int]) -> Submission:
        program = self.rows[places[0]].submission
        assert program is not None
        return program

    def _fill(self, number: int, row: Row) -> None:
        self.rows[number] = row
        self._filled += 1
        if self._lines is not None:
            self._lines.add(row)
        count = f"{self._filled}/{len(self.rows)}".rjust(2 * len(str(len(self.rows))) + 1)
        verdict = None if row.outcome is None else row.outcome.verdict
        line = Text(f"{count}  ", style="dim").append(verdict_text(verdict, width=4))
        score = "" if row.outcome is None else str(row.outcome.score)
        line.append(f" {score:>4}  {row.student}  {row.file}")
        said = row.reason or diagnosis(row) or failure(row)
        for text in (said, "judged before" if row.kept else ""):
            line.append(f"  {text}" if text else "", style="dim")
        self._console.print(line, soft_wrap=True)


def _missing_tool(program: Submission) -> str:
    """Return which tool of the language is missing here, or ""."""
    try:
        toolchain(program.language)
    except LanguageError as error:
        return str(error)
    return ""
