"""One row for each hand-in: who, which file, and how it was judged or why it could not be."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from judge.batch.entries import UnreadableError
from judge.batch.layouts import HandIn
from judge.batch.outcome import Outcome
from judge.batch.similar import nearly_identical, shingles
from judge.kit.errors import KitError
from judge.kit.text import printable_name
from judge.languages.chosen import only_source
from judge.languages.submission import Submission, SubmissionError, from_source
from judge.languages.table import Language, by_suffix
from judge.problem.declaration import Limits

MOST_NOTED = 3  # other hand-ins that a note names


@dataclass(frozen=True, slots=True)
class Row:
    """One hand-in. All texts are printable.

    reason: why it cannot be judged; then submission is None. note: which others are identical
    or nearly identical. outcome: None until it is judged. kept: the outcome is of an earlier
    judging.
    """

    student: str
    file: str
    late: bool
    submission: Submission | None
    reason: str = ""
    note: str = ""
    outcome: Outcome | None = None
    kept: bool = False


def key_of(submission: Submission) -> str:
    """Return what is judged once: language and content."""
    return f"{submission.language.name} {hashlib.sha256(submission.source).hexdigest()}"


def row_of(hand_in: HandIn, limits: Limits, language: Language | None) -> Row:
    """Read a hand-in. language: of all programs; None: by suffix, else by the text."""
    files = [entry for entry in hand_in.entries if entry.is_file]
    readable = {entry.path: entry for entry in files if not entry.fault}
    student = printable_name(hand_in.student)
    first = (files or hand_in.entries)[0].path
    several = len(files) > 1 and len(first.parts) > 1
    shown = printable_name(str(first.parent if several else first))
    try:
        if len(readable) < len([entry for entry in files if not entry.fault]):
            raise SubmissionError("expected different names, found two files with the same name")
        if files and not readable:
            raise UnreadableError(files[0].fault)
        path = only_source(list(readable))
        shown = printable_name(str(path))
        source = readable[path].read((limits.code_kib << 10) + 1)
        if len(source) > limits.code_kib << 10:
            raise SubmissionError(f"the source has more than {limits.code_kib} KiB, the limit")
        found = from_source(source, path.name, language or by_suffix(path))
    except KitError as error:
        why = printable_name(str(error)).removeprefix(f"{shown.rpartition('/')[2]}: ")
        return Row(student, shown, hand_in.late, None, why)
    # Judged under a neutral name: an outcome may be shown in the rows of several students.
    neutral = Submission(f"submission{found.language.suffixes[0]}", found.language, found.source)
    return Row(student, shown, hand_in.late, neutral)


def notes(rows: Sequence[Row]) -> list[str]:
    """Return a note for each row: which other hand-ins are identical or nearly identical."""
    programs = [row.submission for row in rows]
    unique: dict[bytes, list[int]] = {}
    for number, program in enumerate(programs):
        if program is not None:
            unique.setdefault(program.source, []).append(number)
    groups = list(unique.values())
    firsts = [programs[group[0]] for group in groups]
    near = nearly_identical([shingles(p.source, p.language) for p in firsts if p is not None])
    found = [""] * len(rows)
    for place, group in enumerate(groups):
        close = [
            f"{_called(rows[groups[other][0]])} ({int(100 * share)} %)"
            for share, other in near.get(place, [])
        ]
        for number in group:
            same = [_called(rows[other]) for other in group if other != number]
            parts = (_listed("identical to", same), _listed("nearly identical to", close))
            found[number] = "; ".join(filter(None, parts))
    return found


def points(row: Row) -> Mapping[str, int]:
    """Return the points of each group that was judged."""
    groups = [] if row.outcome is None else row.outcome.groups
    return {group.name: group.score for group in groups if group.max_score}


def diagnosis(row: Row) -> str:
    """Return the diagnosis as one text: ids of lessons, the known bug, what else is said."""
    found = row.outcome
    if found is None:
        return ""
    like = f"like a program that {found.bug} ({found.like})" if found.like else ""
    return "; ".join(filter(None, (", ".join(found.lessons), like, found.remark)))


def failure(row: Row) -> str:
    """Return the first failure on one line; of a compiler's messages, the first error."""
    lines = [""] if row.outcome is None else row.outcome.failure.split("\n")
    return next((line for line in lines if "error" in line), lines[0])


def _called(row: Row) -> str:
    return f"{row.student}, {row.file}" if row.student not in row.file else row.file


def _listed(what: str, others: Sequence[str]) -> str:
    if not others:
        return ""
    more = f" and {len(others) - MOST_NOTED} more" if len(others) > MOST_NOTED else ""
    return f"{what} {'; '.join(others[:MOST_NOTED])}{more}"
