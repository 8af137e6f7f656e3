"""Chooses the one source file among all files that a student handed in."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import PurePath
from typing import TypeVar

from judge.kit.text import counted, printable_name
from judge.languages.submission import SubmissionError
from judge.languages.table import by_suffix

P = TypeVar("P", bound=PurePath)
MOST_NAMED = 5
UNPACKED = "__MACOSX"  # what macOS adds to a zip; its other additions begin with a dot


def is_hidden(name: str) -> bool:
    """Tell whether a file or folder of this name never counts."""
    return name.startswith(".") or name == UNPACKED


def only_source(paths: Sequence[P]) -> P:
    """Return the only source file. Raises SubmissionError: what is there instead.

    Only suffixes of known languages count, unless there is one file alone.
    """
    sources = [path for path in paths if by_suffix(path)] or list(paths)
    if len(sources) == 1:
        return sources[0]
    if not sources:
        raise SubmissionError("expected one source file, found none")
    names = [printable_name(str(path)) for path in sources]
    shown = ", ".join(names[:MOST_NAMED])
    more = f" and {len(names) - MOST_NAMED:,} more" if len(names) > MOST_NAMED else ""
    found = counted(len(names), "file")
    raise SubmissionError(f"expected one source file, found {found}: {shown}{more}")
