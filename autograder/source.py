"""Finds and reads the one source file that a student handed in, whatever lies beside it."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from judge.kit.text import counted, printable_name
from judge.languages.guess import guess
from judge.languages.submission import Submission, SubmissionError, read_submission
from judge.languages.table import LANGUAGES, by_suffix
from judge.languages.toolchain import toolchain

UNPACKED = "__MACOSX"  # what macOS adds to a zip; its other additions begin with a dot
MOST_NAMED = 5


def handed_in(directory: Path) -> Submission:
    """Return the submission that lies below a directory, called by its path in there.

    Raises SubmissionError, LanguageError: what is wrong with what was handed in.
    """
    path = find_source(directory)
    name = str(path.relative_to(directory))
    try:
        language = by_suffix(path) or guess(path.read_bytes().decode("utf-8", "replace"))
        if language is None:
            suffixes = " ".join(suffix for each in LANGUAGES for suffix in each.suffixes)
            raise SubmissionError(f"{name}: expected a suffix among {suffixes}")
        submission = read_submission(path, language)
    except SubmissionError as error:
        raise SubmissionError(str(error).replace(f"{directory}/", "")) from None
    toolchain(language)
    return replace(submission, name=name)


def find_source(directory: Path) -> Path:
    """Return the only source file below `directory`. Raises SubmissionError: what is there instead.

    Only suffixes of known languages count, unless there is one file alone. Hidden files and links
    do not count: a link could lead to the reference solution.
    """
    files = sorted(_files(directory))
    sources = [path for path in files if by_suffix(path)] or files
    if len(sources) == 1:
        return sources[0]
    if not files:
        raise SubmissionError("expected one source file, found none")
    names = [printable_name(str(path.relative_to(directory))) for path in sources]
    shown = ", ".join(names[:MOST_NAMED])
    more = f" and {len(names) - MOST_NAMED:,} more" if len(names) > MOST_NAMED else ""
    found = counted(len(names), "file")
    raise SubmissionError(f"expected one source file, found {found}: {shown}{more}")


def _files(directory: Path) -> Iterator[Path]:
    """Yield the regular files below `directory`, except hidden ones."""
    for folder, folders, names in os.walk(directory):
        folders[:] = [name for name in folders if name != UNPACKED and not name.startswith(".")]
        for name in names:
            path = Path(folder, name)
            if not name.startswith(".") and stat.S_ISREG(path.lstat().st_mode):
                yield path
