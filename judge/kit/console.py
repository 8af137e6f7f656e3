"""The consoles of all commands: what they print is data and never markup."""

from __future__ import annotations

import errno
import os
import sys

from rich.console import Console

UNCUT_WIDTH = 10_000  # columns where no terminal is: no name is cut there


class PlainConsole(Console):
    """A console that takes `[red]` in a name for a name, and a lost reader for an error.

    stderr: print to standard error instead of standard output. Where that is no terminal,
    tables are as wide as they need to be.
    """

    def __init__(self, *, stderr: bool = False) -> None:
        stream = sys.stderr if stderr else sys.stdout
        super().__init__(
            stderr=stderr,
            markup=False,
            emoji=False,
            highlight=False,
            width=None if stream.isatty() else UNCUT_WIDTH,
        )

    def on_broken_pipe(self) -> None:
        """Raise BrokenPipeError, which `judge.kit.command` expects, where rich would exit."""
        raise BrokenPipeError(errno.EPIPE, os.strerror(errno.EPIPE))
