"""What both commands of this room print to and write to."""

from __future__ import annotations

from rich.console import Console

UNCUT_WIDTH = 10_000  # of what is not printed to a terminal: no name is cut there


def table_console() -> Console:
    """Return a console for tables: as wide as the terminal, or as the tables if it is none."""
    console = Console(highlight=False)
    return console if console.is_terminal else Console(highlight=False, width=UNCUT_WIDTH)


def counted(number: int, noun: str) -> str:
    """Return a number with its noun.

    >>> counted(1, "case"), counted(1_000, "case")
    ('1 case', '1,000 cases')
    """
    return f"{number:,} {noun}" if number == 1 else f"{number:,} {noun}s"
