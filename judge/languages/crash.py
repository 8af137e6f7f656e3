"""What a crashed program says about its crash: the line of its source, and the reason."""

from __future__ import annotations

import re

from judge.kit.text import printable_lines
from judge.languages.table import Language

COMPILER_LINES = 12  # so many are shown, as by printable_lines
MOST_LINES = 1000
WIDTH = 200
# What the words of a runtime mean. The first that is found is told.
MEANINGS = (
    (r"RecursionError|StackOverflowError|overflowed its stack|stack overflow|call stack size",
     "too many calls inside one another: the recursion is too deep"),
    (r"terminate called", "no part of the program catches this exception"),
    (r"MemoryError|OutOfMemoryError|bad_alloc|out of memory", "more memory than it may use"),
)  # fmt: skip


def crash_reason(language: Language, source: str, stderr: bytes) -> str:
    """Return one line that says why the program crashed; it may be empty.

    source: the name of its source file. The reason is what `error_line` of the language
    matches, else the last line of standard error; `error_place` finds the line of the source.
    """
    text = "\n".join(line.rstrip() for line in stderr.decode("utf-8", "replace").splitlines())
    said = _matched(language.error_line, text) or (
        text.strip("\n").rpartition("\n")[2].encode("utf-8")
    )
    reason = printable_lines(said, lines=1, width=WIDTH)
    meaning = next((plain for words, plain in MEANINGS if re.search(words, reason)), "")
    if meaning:
        reason += f" ({meaning})"
    line = _line(language, source, text)
    return f"line {line}: {reason}" if line else reason


def _matched(pattern: str, text: str) -> bytes:
    """Return what a pattern, or its group, matches first, with lines joined; empty if nothing."""
    found = re.search(pattern, text, re.MULTILINE) if pattern else None
    return b"" if found is None else " ".join(found[found.lastindex or 0].split()).encode("utf-8")


def _line(language: Language, source: str, text: str) -> str:
    """Return the number of the line of `source` where it crashed; empty if it is not told."""
    if not language.error_place:
        return ""
    pattern = language.error_place.replace("{source}", re.escape(source))
    found = re.findall(pattern, text, re.MULTILINE)
    if not found:
        return ""
    place: str = found[-1 if language.newest_call_last else 0]
    return place


def shown_stderr(stderr: bytes, source: str, name: str) -> str:
    """Return standard error as printable lines; paths of the source become the user's `name`."""
    text = re.sub(
        rb"[^\s\"'(:]*/" + re.escape(source).encode(), lambda _found: name.encode(), stderr
    )
    return printable_lines(text, lines=MOST_LINES)


def compiler_lines(said: bytes) -> str:
    """Return what a compiler says, as printable lines: of a long text, from the first error on."""
    lines = said.splitlines(keepends=True)
    first = next((i for i, line in enumerate(lines) if re.search(rb"(?i)\berror\b", line)), 0)
    return printable_lines(said if len(lines) <= COMPILER_LINES else b"".join(lines[first:]))
