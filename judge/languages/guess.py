"""Guesses the language of a source text that has no file name."""

from __future__ import annotations

import re
from functools import cache

from judge.languages.table import LANGUAGES, Language, by_name

GUESS_CHARS = 1 << 20  # more than any limit on the source


def guess(text: str) -> Language | None:
    """Return the language of a source text, None if nothing hints at one.

    A `#!` line for Python or PyPy decides. Otherwise, a text that looks like Python is Python;
    this comes early because its comments and strings may hold hints of other languages.
    Otherwise, the first language with a matching hint is taken; the order matters because the
    hints of later ones also occur in texts of earlier ones. Only the first GUESS_CHARS
    characters are read. Linear time.
    """
    # A hint such as `\s*` is slow on long white space, so each run of it becomes one space.
    lines = (re.sub(r"\s+", " ", line).rstrip() for line in text[:GUESS_CHARS].split("\n"))
    text = "\n".join(line for line in lines if line)
    first = text[: text.find("\n")] if text.startswith("#!") else ""
    if "pypy" in first:
        return by_name("PyPy 3")
    if "python" in first:
        return by_name("Python 3")
    if _python_block().search(text) and not _statement_end().search(text):
        return by_name("Python 3")
    return next((each for each in LANGUAGES if _pattern(*each.hints).search(text)), None)


def _python_block() -> re.Pattern[str]:
    """Return a pattern for an import or the head of a block as only Python writes them."""
    return _pattern(
        r"^(?:import|from)\s+\w[\w.]*(?:\s+import\b.*|\s+as\s+\w+|\s*,.*)?$",
        r"^\s*(?:def|class|for|while|if|with|try)\b.*:\s*(?:#.*)?$",
    )


def _statement_end() -> re.Pattern[str]:
    """Return a pattern for lines of other languages: ending in `;` or `{`, or `package main`."""
    return _pattern(r"[;{]\s*(?://.*)?$", r"^\s*package\s+main\b")


@cache
def _pattern(*alternatives: str) -> re.Pattern[str]:
    return re.compile("|".join(alternatives), re.MULTILINE)
