"""The one progress bar of the kit: shown on a terminal while something takes its time."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import Progress, TaskID


class Bar:
    """A bar with a description, and a count once the total is known."""

    def __init__(self, progress: Progress, task: TaskID) -> None:
        self._progress = progress
        self._task = task

    def say(self, description: str) -> None:
        """Change what the bar is said to be doing."""
        self._progress.update(self._task, description=description)

    def begin(self, total: int, description: str | None = None) -> None:
        """Tell how many steps there will be."""
        self._progress.update(self._task, total=total, description=description)

    def advance(self, steps: int = 1) -> None:
        """Count steps that are done."""
        self._progress.advance(self._task, steps)


@contextmanager
def progress_bar(
    description: str, total: int | None = None, console: Console | None = None
) -> Iterator[Bar]:
    """Show a bar while the block runs, and nothing of it afterwards.

    total: None as long as nobody knows. console: where; standard error if None. Where that
    is no terminal, nothing is shown.
    """
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        SpinnerColumn,
        TextColumn,
        TimeElapsedColumn,
    )

    from judge.kit.console import PlainConsole

    console = console or PlainConsole(stderr=True)
    text = TextColumn("{task.description}", markup=False)
    columns = (SpinnerColumn(), text, BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(
        *columns, console=console, transient=True, disable=not console.is_terminal
    ) as progress:
        yield Bar(progress, progress.add_task(description, total=total))
