"""Makes untrusted text safe to print: no control characters, limited length."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

ELLIPSIS = "…"


def printable(data: bytes, limit: int = 40) -> str:
    r"""Return `data` as one line of printable ASCII, cut to `limit` characters and a `…`.

    Every other byte becomes `\xNN`, so that no output can move a cursor, fake a
    verdict or break a table. O(limit).

    >>> printable(b"YES")
    'YES'
    >>> printable(b"\x1b[2J")
    '\\x1b[2J'
    """
    shown = "".join(chr(b) if 32 <= b < 127 else f"\\x{b:02x}" for b in data[: limit + 1])
    return shown if len(shown) <= limit else shown[:limit] + ELLIPSIS


def printable_lines(data: bytes, lines: int = 12, width: int = 160) -> str:
    """Return the first `lines` lines of `data`, each cut to `width`, and a `…` if there are more.

    UTF-8 text stays readable; unprintable bytes and characters are escaped.
    """
    text = data.decode("utf-8", "backslashreplace").expandtabs(4).strip("\r\n")
    found = text.splitlines()
    kept = [_printable_text(line.rstrip(), width) for line in found[:lines]]
    if len(found) > lines:
        kept.append(ELLIPSIS)
    return "\n".join(kept)


def printable_name(name: str, width: int = 400) -> str:
    """Return a file name, or a message that holds one, as one printable line."""
    return _printable_text(name, width)


def did_you_mean(word: str, choices: Iterable[str]) -> str:
    """Return `; did you mean 'x'?` for the nearest choice, or an empty string."""
    near = difflib.get_close_matches(word, list(choices), n=1)
    return f"; did you mean {near[0]!r}?" if near else ""


def _printable_text(line: str, width: int) -> str:
    shown = "".join(
        c if c.isprintable() else c.encode("unicode_escape").decode() for c in line[: width + 1]
    )
    return shown if len(shown) <= width else shown[:width] + ELLIPSIS


def counted(number: int, noun: str) -> str:
    """Return a number with its noun.

    >>> counted(1, "case"), counted(1_000, "case")
    ('1 case', '1,000 cases')
    """
    return f"{number:,} {noun}" if number == 1 else f"{number:,} {noun}s"
