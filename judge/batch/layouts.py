"""Whose file is it? The layouts of the downloads of Moodle, Canvas, Gradescope and DOMjudge.

Moodle:     `Ann Lee_123_assignsubmission_file_/prog.py`, or flat `..._file_prog.py`
Canvas:     `leeann_123_456_prog.py`, `leeann_LATE_123_456_prog.py`
Gradescope: `submission_123/prog.py`, with the names in `submission_metadata.yml`
DOMjudge:   `s123.py`, or a folder for each team with one or more of these
otherwise:  a folder is one student's; a file that lies in no folder is one student's
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import PurePosixPath

from judge.batch.entries import OUTSIDE, Entry, UnreadableError
from judge.batch.gradescope import METADATA, MOST_BYTES, students
from judge.languages.table import by_suffix

_MOODLE = re.compile(r"(?P<student>.+)_(?P<id>\d+)_assignsubmission_(?:file|onlinetext)_?.*")
_CANVAS = re.compile(r"(?P<student>[^_]+)_(?P<late>LATE_)?(?P<id>\d+)_\d+_.+")
_GRADESCOPE = re.compile(r"submission_\d+")
_STUDENT = re.compile(f"{_MOODLE.pattern}|{_GRADESCOPE.pattern}")
_DOMJUDGE = re.compile(r"s\d+(?:\.[^.]+)?")


@dataclass(frozen=True, slots=True)
class HandIn:
    """What one student handed in. late: the download says so."""

    student: str
    late: bool = False
    entries: list[Entry] = field(default_factory=list)


def hand_ins(entries: Sequence[Entry]) -> list[HandIn]:
    """Return the hand-ins, in the order of their first files. O(n) for n sorted entries."""
    above = _wrapper(entries)
    names = _names(entries, above)
    found: dict[tuple[str, ...], HandIn] = {}
    for entry in entries:
        if entry.path == above / METADATA:
            continue
        if entry.fault == OUTSIDE:
            found[("", str(entry.path))] = HandIn(str(entry.path), entries=[entry])
            continue
        path = entry.path.relative_to(above)
        key, hand_in = _owner(path, names, alone=entry.is_file and len(path.parts) == 1)
        known = found.setdefault(key, hand_in)
        if hand_in.late and not known.late:
            known = found[key] = replace(known, late=True)
        known.entries.append(entry)
    return list(found.values())


def _owner(
    path: PurePosixPath, names: dict[str, str], *, alone: bool
) -> tuple[tuple[str, ...], HandIn]:
    """Return what tells hand-ins apart, and the hand-in without entries.

    alone: it is a file that lies in no folder.
    """
    top = path.parts[0]
    if match := _MOODLE.fullmatch(top):
        return ("moodle", match["student"], match["id"]), HandIn(match["student"])
    if alone and (match := _CANVAS.fullmatch(top)):
        late = match["late"] is not None
        return ("canvas", match["student"], match["id"]), HandIn(match["student"], late)
    if alone:
        return ("file", top), HandIn(path.stem)
    if _GRADESCOPE.fullmatch(top):
        return ("folder", top), HandIn(names.get(top, top))
    if len(path.parts) > 1 and _DOMJUDGE.fullmatch(path.parts[1]):
        return ("team", top, path.parts[1]), HandIn(top)
    return ("folder", top), HandIn(top)


def _wrapper(entries: Sequence[Entry]) -> PurePosixPath:
    """Return the folders that hold everything, as many zips have one: `.` if there are none.

    A folder that holds a single source file is no wrapper: it is the only student's.
    """
    paths = [entry.path for entry in entries if entry.fault != OUTSIDE]
    several = sum(by_suffix(path) is not None for path in paths) > 1
    above = PurePosixPath()
    while True:
        depth = len(above.parts)
        tops = {path.parts[depth] for path in paths if len(path.parts) > depth}
        top = next(iter(tops), "")
        children = {path.parts[depth + 1] for path in paths if len(path.parts) > depth + 1}
        wraps = several or METADATA in children
        if len(tops) != 1 or not children or not wraps or _STUDENT.fullmatch(top):
            return above
        above /= top


def _names(entries: Sequence[Entry], above: PurePosixPath) -> dict[str, str]:
    """Return the students' names by folder, as Gradescope says them; none if it does not."""
    for entry in entries:
        if entry.path == above / METADATA and not entry.fault:
            try:
                return students(entry.read(MOST_BYTES).decode("utf-8", "replace"))
            except UnreadableError:
                break
    return {}
