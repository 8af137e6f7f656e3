"""What every command line owes its user: one line and an exit status, never a traceback."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TextIO

NOT_WRITTEN, FAILED, INTERRUPTED = 1, 2, 130


def run(
    name: str,
    command: Callable[[], int],
    errors: tuple[type[Exception], ...] = (),
    interrupted: str = "interrupted",
) -> int:
    """Return the exit status of a command, whatever becomes of it or of its streams.

    errors: of the user's making, each one clear line: 2. A file that cannot be used, or
    output that cannot be written: 2; but 1, and not a word, if the reader went away as
    `head` does. Interrupted: 130, and what `interrupted` says.
    """
    if sys.stderr is None:
        sys.stderr = Path(os.devnull).open("w")  # noqa: SIM115 (to the end of the process)
    if sys.stdin is None:
        sys.stdin = Path(os.devnull).open()  # noqa: SIM115
    if sys.stdout is None:
        complain(f"{name}: standard output is closed")
        return FAILED
    try:
        status = command()
        sys.stdout.flush()
    except errors as error:
        complain(f"{name}: {error}")
        return FAILED
    except KeyboardInterrupt:
        complain(f"{name}: {interrupted}")
        return INTERRUPTED
    except BrokenPipeError:
        give_up(sys.stdout)
        return NOT_WRITTEN
    except OSError as error:
        if error.filename is None:
            give_up(sys.stdout)
        complain(f"{name}: {error.filename or 'standard output'}: {error.strerror}")
        return FAILED
    return status


def complain(line: str) -> None:
    """Say one line on standard error, if anybody can be told."""
    try:
        print(line, file=sys.stderr, flush=True)
    except OSError:
        give_up(sys.stderr)


def give_up(stream: TextIO) -> None:
    """Point a stream that cannot be written to nowhere, so that its flush at the end succeeds."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
