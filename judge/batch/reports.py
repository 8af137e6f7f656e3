"""The reports on a class: a CSV table, lines of JSON as they come, and one HTML page."""

from __future__ import annotations

import csv
import io
import os
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Self

import msgspec

from judge.batch.rows import Row, diagnosis, failure, points
from judge.batch.similar import LEAST, K
from judge.kit.files import FileError
from judge.problem.declaration import Problem
from judge.reports.html import MEANING
from judge.reports.page import render

TEMPLATES = Path(__file__).with_name("templates")
FORMULA = ("=", "+", "-", "@")  # a spreadsheet computes a cell that begins so
FIRST_LESSONS = 8  # on the page; the others are folded
CODEC = "utf-8-sig"  # with a byte order mark, or Excel takes it for another encoding


class JsonLines:
    """A file of one JSON object a line; each line is written at once, as soon as it is known."""

    def __init__(self, option: str, path: Path) -> None:
        self._where = f"{option} {path}"
        try:
            flags = os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_APPEND | os.O_CLOEXEC
            path.parent.mkdir(exist_ok=True)
            self._descriptor = os.open(path, flags, 0o644)
        except OSError as error:
            raise FileError(f"{self._where}: {error.strerror}") from None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        _kind: type[BaseException] | None,
        _error: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:
        os.close(self._descriptor)

    def add(self, row: Row) -> None:
        """Append a row. Raises FileError."""
        line = memoryview(msgspec.json.encode(as_json(row)) + b"\n")
        try:
            while line:  # more than once only if the disk is nearly full
                line = line[os.write(self._descriptor, line) :]
        except OSError as error:
            raise FileError(f"{self._where}: {error.strerror}") from None


def as_json(row: Row) -> dict[str, object]:
    """Return a row as one JSON object; `verdict` is null if it cannot be judged."""
    found = row.outcome
    return {
        "student": row.student,
        "file": row.file,
        "late": row.late,
        "language": None if row.submission is None else row.submission.language.name,
        "verdict": None if found is None else found.verdict,
        "score": None if found is None else found.score,
        "max_score": None if found is None else found.max_score,
        "partial": None if found is None else found.partial,
        "groups": [] if found is None else found.groups,
        "cpu_s": None if found is None else found.cpu_s,
        "failure": "" if found is None else found.failure,
        "lessons": [] if found is None else found.lessons,
        "like": "" if found is None else found.like,
        "bug": "" if found is None else found.bug,
        "remark": "" if found is None else found.remark,
        "note": row.note,
        "reason": row.reason,
        "wall": None if found is None else found.wall,
        "scale": None if found is None else found.scale,
        "kept": row.kept,
    }


def to_csv(rows: Sequence[Row], problem: Problem) -> bytes:
    """Return the table, one row for each hand-in; no cell can be a formula."""
    groups = [group.name for group in problem.groups if group.points]
    text = io.StringIO(newline="")
    table = csv.writer(text)
    head = ["student", "file", "late", "language", "verdict", "score", "max_score", *groups]
    table.writerow([*head, "cpu_s", "diagnosis", "failure", "note", "reason"])
    for row in rows:
        found, scored = row.outcome, points(row)
        cells = [row.student, row.file, "LATE" if row.late else ""]
        cells += ["" if row.submission is None else row.submission.language.name]
        if found is None:
            cells += [""] * (len(groups) + 6)
        else:
            cells += [found.verdict, str(found.score), str(found.max_score)]
            cells += [str(scored.get(group, "")) for group in groups]
            cells += [f"{found.cpu_s:.2f}", diagnosis(row), failure(row)]
        table.writerow([plain(cell) for cell in (*cells, row.note, row.reason)])
    return text.getvalue().encode(CODEC)


def plain(cell: str) -> str:
    """Return a cell that every spreadsheet takes for text, on one line.

    >>> plain("=1+1"), plain("Ann")
    ("'=1+1", 'Ann')
    """
    line = " ".join(cell.split())
    return f"'{line}" if line.startswith(FORMULA) else line


def to_page(rows: Sequence[Row], problem: Problem, title: str, lessons: Mapping[str, str]) -> bytes:
    """Return the page. lessons: the sentences by id."""
    judged = [row.outcome for row in rows if row.outcome is not None]
    missed = Counter(lesson for outcome in judged for lesson in outcome.lessons)
    groups = [group for group in problem.groups if group.points]
    solved = Counter(group.name for outcome in judged for group in outcome.groups if group.score)
    page = render(
        "class.html",
        TEMPLATES,
        title=title,
        rows=rows,
        judged=len(judged),
        verdicts=Counter(outcome.verdict for outcome in judged).most_common(),
        groups=groups,
        solved=solved,
        missed=[(lesson, many, lessons.get(lesson, "")) for lesson, many in missed.most_common()],
        partial=any(outcome.partial for outcome in judged),
        first=FIRST_LESSONS,
        least=round(100 * LEAST),
        tokens=K,
        mean=sum(outcome.score for outcome in judged) / len(judged) if judged else 0.0,
        max_score=problem.max_score,
        points=points,
        diagnosis=diagnosis,
        failure=failure,
        meaning=MEANING,
    )
    return page.encode()
