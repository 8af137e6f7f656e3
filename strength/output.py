"""What both commands of this room print to and write to."""

from __future__ import annotations

from pathlib import Path

from rich.console import Console

from judge.kit.errors import KitError
from judge.kit.files import write_whole
from judge.kit.paths import BUILD

UNCUT_WIDTH = 10_000  # of what is not printed to a terminal: no name is cut there


class OutputError(KitError):
    """A report cannot be written where it is asked for."""


def table_console() -> Console:
    """Return a console for tables: as wide as the terminal, or as the tables if it is none."""
    console = Console(highlight=False)
    return console if console.is_terminal else Console(highlight=False, width=UNCUT_WIDTH)


def check_place(option: str, path: Path | None) -> None:
    """Raise OutputError if a report cannot be written to `path`, before hours of work.

    build/ is made where it is missing; other directories must be there.
    """
    if path is None:
        return
    directory = path.absolute().parent
    if not directory.is_dir() and directory != BUILD:
        raise OutputError(f"{option} {path}: no such directory")
    if path.is_dir():
        raise OutputError(f"{option} {path}: expected a file, found a directory")


def write_report(option: str, path: Path | None, content: bytes) -> None:
    """Write a report if one was asked for. Raises OutputError."""
    if path is None:
        return
    try:
        write_whole(path, content, parents=True)
    except OSError as error:
        raise OutputError(f"{option} {path}: {error.strerror}") from None


def counted(number: int, noun: str) -> str:
    """Return a number with its noun.

    >>> counted(1, "case"), counted(1_000, "case")
    ('1 case', '1,000 cases')
    """
    return f"{number:,} {noun}" if number == 1 else f"{number:,} {noun}s"
