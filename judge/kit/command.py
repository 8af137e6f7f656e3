"""Every command ends with one line and an exit status, never a traceback."""

from __future__ import annotations

import argparse
import io
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TextIO

from judge.kit.errors import KitError
from judge.kit.text import did_you_mean, printable_name

MESSAGE_CHARS = 2000
READER_GONE, FAILED, INTERRUPTED = 1, 2, 130


def run(
    name: str,
    command: Callable[[], int],
    errors: tuple[type[Exception], ...] = (),
    interrupted: str = "interrupted",
    reader_gone: int = READER_GONE,
) -> int:
    """Run a command and return its exit status, whatever happens to it or to its streams.

    KitError, `errors`, a file that cannot be used, output that cannot be written: one line on
    standard error and status 2. If the reader of the output goes away, as `head` does: no
    message, and status `reader_gone`. Ctrl-C: the line `interrupted` and status 130.
    """
    if sys.stderr is None:
        sys.stderr = Path(os.devnull).open("w")  # noqa: SIM115 (open until the process ends)
    if sys.stdin is None:
        sys.stdin = Path(os.devnull).open()  # noqa: SIM115
    if sys.stdout is None:
        complain(f"{name}: standard output is closed")
        return FAILED
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # any file name can be printed
            stream.reconfigure(errors="backslashreplace")
    told: tuple[type[Exception], ...] = (KitError, *errors)
    try:
        status = _status(command)
        sys.stdout.flush()
    except told as error:
        complain(f"{name}: {printable_name(str(error), MESSAGE_CHARS)}")
        return FAILED
    except KeyboardInterrupt:
        complain(f"{name}: {interrupted}")
        return INTERRUPTED
    except BrokenPipeError:
        give_up(sys.stdout)
        return reader_gone
    except OSError as error:
        if error.filename is None:
            give_up(sys.stdout)
        where = "standard output" if error.filename is None else str(error.filename)
        complain(f"{name}: {printable_name(where)}: {error.strerror}")
        return FAILED
    return status


def _status(command: Callable[[], int]) -> int:
    """Run a command; argparse prints its own message and raises SystemExit."""
    try:
        return command()
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else 0


def complain(line: str) -> None:
    """Print one line on standard error, if that is possible."""
    try:
        print(line, file=sys.stderr, flush=True)
    except OSError:
        give_up(sys.stderr)


def give_up(stream: TextIO) -> None:
    """Redirect a broken stream to /dev/null, so that its flush at exit succeeds."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


class Parser(argparse.ArgumentParser):
    """The parser of every command line of the kit: of a mistyped option it names the nearest."""

    def parse_args(  # type: ignore[override] # the kit needs no other namespace
        self, args: Sequence[str] | None = None, namespace: None = None
    ) -> argparse.Namespace:
        """Return the options. Exits with status 2 if there are unknown ones."""
        found, unknown = self.parse_known_args(args, namespace)
        if unknown:
            word = unknown[0].partition("=")[0]
            near = did_you_mean(word, self._options()) if word.startswith("-") else ""
            self.error(f"unrecognized arguments: {' '.join(unknown)}{near}")
        return found

    def _options(self) -> Iterator[str]:
        """Yield all options, also those of the commands of a command."""
        for action in self._actions:
            yield from action.option_strings
            if isinstance(action, argparse._SubParsersAction):
                for parser in action.choices.values():
                    yield from parser._options()


def whole_number(least: int, most: int | None = None) -> Callable[[str], int]:
    """Return a type for argparse that accepts whole numbers from `least` to `most`.

    >>> whole_number(1)("12")
    12
    """
    expected = f"a whole number of at least {least}" if most is None else f"{least} to {most}"

    def read(text: str) -> int:
        try:
            value = int(text)
        except ValueError:
            value = least - 1
        if value < least or (most is not None and value > most):
            raise argparse.ArgumentTypeError(f"expected {expected}, found {text!r}")
        return value

    return read


def add_jobs(parser: argparse.ArgumentParser, default: int, what: str) -> None:
    """Add the option --jobs, the number of simultaneous `what` (as `runs`)."""
    parser.add_argument(
        "--jobs",
        type=whole_number(1),
        default=default,
        metavar="N",
        help=f"{what} at once (default here: {default})",
    )
