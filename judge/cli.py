"""The command line of checker.py: what is asked for, and the exit status."""

from __future__ import annotations

import argparse
import errno
import io
import os
import signal
import sys
from collections.abc import Sequence
from pathlib import Path

from rich.console import Console

from judge.judging import JudgeError, Options, default_jobs, judge
from judge.kit.command import complain, give_up
from judge.kit.files import write_whole
from judge.kit.paths import DATA
from judge.kit.text import printable_name
from judge.languages.submission import (
    Submission,
    SubmissionError,
    from_source,
    read_source,
    read_submission,
)
from judge.languages.table import LanguageError, by_name
from judge.problem.cases import CasesError
from judge.problem.declaration import SpecError, load
from judge.problem.verdict import Verdict
from judge.reports.junit import to_junit
from judge.reports.schema import to_json
from judge.reports.terminal import Live, print_report
from judge.sandbox.sandbox import SandboxError

EXIT_ACCEPTED, EXIT_REJECTED, EXIT_ERROR, EXIT_INTERRUPTED = 0, 1, 2, 130

USAGE_ERRORS = (SpecError, SubmissionError, LanguageError, CasesError, JudgeError, SandboxError)

EXAMPLES = """\
examples:
  ./checker.py submissions/accepted/textbook.py
  ./checker.py my.cpp --group small --group large
  ./checker.py my.py --case 'static/03-*' --time-limit 10
  ./checker.py my.py --data my_cases --json report.json
  ./checker.py < my.py
  ssh host cat my.java | ./checker.py - --language java

exit status: 0 accepted, 1 not accepted, 2 usage or judge error, 130 interrupted
"""


def main(arguments: Sequence[str] | None = None) -> int:
    """Judge as the arguments say and return the exit status."""
    parser = _parser()
    asked = parser.parse_args(arguments)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # whatever a file is called, it can be said
            stream.reconfigure(errors="backslashreplace")
    if asked.submission is None and (sys.stdin is None or sys.stdin.isatty()):
        parser.print_help()
        return EXIT_ERROR
    signal.signal(signal.SIGTERM, _interrupt)
    signal.signal(signal.SIGHUP, _interrupt)
    try:
        return _judge(asked)
    except USAGE_ERRORS as error:
        _complain(printable_name(str(error)))
        return EXIT_ERROR
    except KeyboardInterrupt:
        _complain("interrupted, nothing is left running")
        return EXIT_INTERRUPTED
    except OSError as error:  # of our own output: its reader went away, or its disk is full
        give_up(sys.stdout)
        _complain(f"the report cannot be written: {error.strerror}")
        return EXIT_ERROR


class _Console(Console):
    """A console whose lost reader is an error like others, not the end of the process."""

    def on_broken_pipe(self) -> None:
        raise BrokenPipeError(errno.EPIPE, os.strerror(errno.EPIPE))


def _complain(message: str) -> None:
    complain(f"checker.py: {message}")


def _judge(asked: argparse.Namespace) -> int:
    problem = load()
    submission = _submission(asked)
    reports = [
        (option, path, form)
        for option, path, form in (
            ("--json", asked.json, to_json),
            ("--junit", asked.junit, to_junit),
        )
        if path is not None
    ]
    taken = {Path(asked.submission or "-").absolute(): "the submission"}
    for option, path, _ in reports:
        if not path.absolute().parent.is_dir():
            raise JudgeError(f"{option} {path}: no such directory")
        if path.is_dir():
            raise JudgeError(f"{option} {path}: expected a file, found a directory")
        if str(path) == "-":  # the table is there already
            raise JudgeError(f"{option} -: expected a file, found standard output")
        if other := taken.get(path.absolute()):
            raise JudgeError(f"{option} {path}: expected a file of its own, found {other}")
        taken[path.absolute()] = f"the file of {option}"
    options = Options(
        data=DATA if asked.data is None else asked.data.resolve(),
        groups=tuple(asked.group),
        globs=tuple(asked.case),
        jobs=asked.jobs,
        time_limit_s=asked.time_limit,
        stop_on_first=asked.stop_on_first,
        no_wall=asked.no_wall,
    )
    console = _Console(highlight=False)
    with Live(console) as live:
        judging = judge(submission, problem, options, events=live.events)
    print_report(console, judging)
    for option, path, form in reports:
        try:
            write_whole(path, form(judging))
        except OSError as error:
            raise JudgeError(f"{option} {path}: {error.strerror}") from None
    if judging.verdict is Verdict.JE:
        return EXIT_ERROR
    return EXIT_ACCEPTED if judging.verdict is Verdict.AC else EXIT_REJECTED


def _submission(asked: argparse.Namespace) -> Submission:
    language = None if asked.language is None else by_name(asked.language)
    if asked.submission == "":
        raise SubmissionError("expected a source file, found an empty name")
    if asked.submission not in (None, "-"):
        return read_submission(Path(asked.submission), language)
    return from_source(read_source(sys.stdin.buffer), "standard input", language)


def _interrupt(_signal: int, _frame: object) -> None:
    raise KeyboardInterrupt


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="checker.py",
        description="Judge a submission: compile it, run it on every test case within the "
        "limits, compare its output with the answers.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("submission", nargs="?", help="source file; '-' or nothing: standard input")
    add("--language", metavar="NAME", help="instead of what the suffix or the text tells")
    add("--group", action="append", default=[], metavar="NAME", help="only this group; repeatable")
    add("--case", action="append", default=[], metavar="GLOB", help="only these cases; repeatable")
    add("--data", type=Path, metavar="DIR", help="any directory of .in/.ans pairs")
    add("--jobs", type=_at_least_one, default=default_jobs(), metavar="N", help="runs at once")
    add("--time-limit", type=_seconds, metavar="SECONDS", help="CPU seconds a case, not scaled")
    add("--json", type=Path, metavar="FILE", help="write the results as JSON")
    add("--junit", type=Path, metavar="FILE", help="write the results as JUnit XML")
    add("--stop-on-first", action="store_true", help="end each group at its first failure")
    add("--no-wall", action="store_true", help="judge even when no wall can be raised")
    return parser


def _at_least_one(text: str) -> int:
    try:
        value = int(text)
    except ValueError:
        value = 0
    if value < 1:
        raise argparse.ArgumentTypeError(f"expected a whole number of at least 1, found {text!r}")
    return value


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value <= 3600:
        raise argparse.ArgumentTypeError(f"expected seconds in (0, 3600], found {text!r}")
    return value
