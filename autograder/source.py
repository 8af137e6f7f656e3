"""Finds and reads the one source file that a student handed in, whatever lies beside it."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from judge.languages.chosen import is_hidden, only_source
from judge.languages.guess import guess
from judge.languages.submission import Submission, SubmissionError, read_submission
from judge.languages.table import LANGUAGES, by_suffix
from judge.languages.toolchain import toolchain


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

    Hidden files and links do not count: a link could lead to the reference solution.
    """
    return directory / only_source(
        [path.relative_to(directory) for path in sorted(_files(directory))]
    )


def _files(directory: Path) -> Iterator[Path]:
    """Yield the regular files below `directory`, except hidden ones."""
    for folder, folders, names in os.walk(directory):
        folders[:] = [name for name in folders if not is_hidden(name)]
        for name in names:
            path = Path(folder, name)
            if not is_hidden(name) and stat.S_ISREG(path.lstat().st_mode):
                yield path
