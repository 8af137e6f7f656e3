"""The progress bar of all commands, shown on terminals only."""

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
        """Change the description."""
        self._progress.update(self._task, description=description)

    def begin(self, total: int, description: str | None = None) -> None:
        """Set the number of steps; change the description unless it is None."""
        self._progress.update(self._task, total=total, description=description)

    def advance(self, steps: int = 1) -> None:
        """Count `steps` more steps as done."""
        self._progress.advance(self._task, steps)


@contextmanager
def progress_bar(
    description: str,
    total: int | None = None,
    console: Console | None = None,
    *,
    forecast: bool = False,
) -> Iterator[Bar]:
    """Show a bar while the block runs, and remove it afterwards.

    total: the number of steps; None: not known yet. console: where to show the bar; None:
    standard error. forecast: also show the time left, from the recent rate. Nothing is shown if
    that is not a terminal.
    """
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        SpinnerColumn,
        TextColumn,
        TimeElapsedColumn,
        TimeRemainingColumn,
    )

    from judge.kit.console import PlainConsole

    console = console or PlainConsole(stderr=True)
    text = TextColumn("{task.description}", markup=False)
    columns = [SpinnerColumn(), text, BarColumn(), MofNCompleteColumn(), TimeElapsedColumn()]
    if forecast:
        columns += [TextColumn("time left"), TimeRemainingColumn()]
    with Progress(
        *columns, console=console, transient=True, disable=not console.is_terminal
    ) as progress:
        yield Bar(progress, progress.add_task(description, total=total))
