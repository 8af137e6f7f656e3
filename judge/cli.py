"""The command line of checker.py: its options and exit status."""

from __future__ import annotations

import argparse
import os
import signal
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from judge.kit.command import FAILED, Parser, add_jobs, run, whole_number
from judge.kit.errors import KitError
from judge.kit.files import check_place, write_report
from judge.kit.paths import DATA
from judge.kit.processors import cores

if TYPE_CHECKING:
    from judge.explanation import Diagnosis
    from judge.judging import Measure, Search
    from judge.languages.submission import Submission
    from judge.problem.declaration import Problem
    from judge.results import Judging


EXIT_ACCEPTED, EXIT_REJECTED, EXIT_ERROR = 0, 1, FAILED

SUBMISSION = "source file; '-' or nothing: standard input; a directory or zip: a whole class"
EXPLAIN = "looks for a smallest input that it gets wrong"
EXPLAIN_SLOW = "measures what its time grows with"

EXAMPLES = """\
examples:
  ./checker.py submissions/accepted/textbook.py
  ./checker.py my.cpp --group small --group large
  ./checker.py my.py --case 'static/03-*' --time-limit 10
  ./checker.py my.py --data my_cases --json report.json
  ./checker.py < my.py
  ./checker.py class.zip --csv scores.csv --html report.html --json results.jsonl
  ssh host cat my.java | ./checker.py - --language java

exit status: 0 accepted, 1 not accepted, 2 usage or judge error, 130 interrupted; of a class, 0 if
all were judged
"""


@dataclass(frozen=True, slots=True)
class Explainers:
    """What --explain adds, made by rooms that the judge does not import.

    make_search: returns the search for a counterexample that repeats a seed, or one with a new
    seed for None; the flag: add what it finds to the data. illustrate: draws the scene of each
    missed lesson. measure: finds out how the time of a program grows that was too slow.
    """

    make_search: Callable[[int | None, bool], Search]
    illustrate: Callable[[Diagnosis], Diagnosis]
    measure: Measure


class UsageError(KitError):
    """The options contradict each other or cannot be followed."""


def main(
    arguments: Sequence[str] | None = None,
    explainers: Explainers | None = None,
) -> int:
    """Judge as the arguments say and return the exit status.

    explainers: what --explain adds; without them there is no --explain.
    """
    signal.signal(signal.SIGTERM, _interrupt)
    signal.signal(signal.SIGHUP, _interrupt)
    if sys.stdout is None:  # the exit status and the reports are useful alone
        sys.stdout = Path(os.devnull).open("w")  # noqa: SIM115 (open until the process ends)
    interrupted = "interrupted, nothing is left running"
    command = partial(_command, arguments, explainers)
    return run("checker.py", command, interrupted=interrupted, reader_gone=EXIT_ERROR)


def _interrupt(_signal: int, _frame: object) -> None:
    raise KeyboardInterrupt


def _command(arguments: Sequence[str] | None, explainers: Explainers | None) -> int:
    parser = _parser()
    if explainers is not None:
        _add_search(parser)
    asked = parser.parse_args(arguments)
    if asked.submission is None and sys.stdin.isatty():
        parser.print_help()
        return EXIT_ERROR
    if explainers is None:
        return _judge(asked, None, hints=False)
    for option, value in (("--seed", asked.seed), ("--add", asked.add)):
        if value not in (None, False) and not asked.explain:
            raise UsageError(f"{option}: expected --explain with it, found none")
    if not asked.explain:
        return _judge(asked, None, hints=True)
    return _judge(asked, explainers, hints=False)


def _judge(asked: argparse.Namespace, explainers: Explainers | None, *, hints: bool) -> int:
    # Imported here, so that help and usage errors appear at once.
    from judge.batch.entries import is_class
    from judge.judging import UNEXPLAINED, Options, judge
    from judge.problem.declaration import load
    from judge.problem.verdict import Verdict

    problem = load()
    if asked.make_answers:
        _make_answers(asked.data)
    places = _places(asked)
    options = Options(
        data=DATA if asked.data is None else asked.data.resolve(),
        groups=tuple(asked.group),
        globs=tuple(asked.case),
        jobs=asked.jobs,
        time_limit_s=asked.time_limit,
        stop_on_first=not asked.all,
        no_wall=asked.no_wall,
        compact=asked.compact,
    )
    if asked.submission and is_class(Path(asked.submission)):
        from judge.batch.command import command

        return command(asked, problem, options)
    if asked.csv is not None:
        raise UsageError("--csv: expected a directory or a zip with it, found one submission")
    submission = _submission(asked)
    reports = [partial(_write, option, path, _form(option)) for option, path in places]
    from judge.feedback import told
    from judge.kit.console import PlainConsole
    from judge.reports.terminal import live, print_report

    console = PlainConsole()
    explain = explainers is not None
    search = explainers.make_search(asked.seed, asked.add) if explainers else None
    measure = explainers.measure if explainers else None
    with live(console, problem.feedback) as events:
        judging = judge(submission, problem, options, events=events, search=search, measure=measure)
    permitted = told(judging, problem.feedback)
    if explainers is not None and permitted.diagnosis is not None:
        permitted = replace(permitted, diagnosis=explainers.illustrate(permitted.diagnosis))
    if explain and judging.verdict is Verdict.AC:
        console.print("accepted: there is nothing to explain")
    hint = _hint(judging, problem) if hints and judging.verdict not in UNEXPLAINED else ""
    print_report(console, permitted, explain=explain, verbose=asked.verbose, hint=hint)
    for write in reports:
        write(permitted)
    if judging.verdict is Verdict.JE:
        return EXIT_ERROR
    return EXIT_ACCEPTED if judging.verdict is Verdict.AC else EXIT_REJECTED


def _hint(judging: Judging, problem: Problem) -> str:
    """Return what --explain would add to the report of a program that is not accepted."""
    from judge.diagnosis.slowness import first_timeout

    adds = [EXPLAIN] if problem.feedback.counterexample else []
    if problem.feedback.lessons and first_timeout(judging.cases) is not None:
        adds.append(EXPLAIN_SLOW)
    return f"--explain {' and '.join(adds)}" if adds else ""


def _make_answers(directory: Path | None) -> None:
    from judge.problem.given import make_answers
    from judge.reports.words import shown

    if directory is None:
        raise UsageError("--make-answers: expected --data DIR, too")
    for path in make_answers(directory.resolve()):
        print(f"answered by the reference: {shown(path)}")


def _places(asked: argparse.Namespace) -> list[tuple[str, Path]]:
    """Return the options that ask for reports and their places, after checking these."""
    found: list[tuple[str, Path]] = []
    taken = {Path(asked.submission or "-").absolute(): "the submission"}
    for option in ("--json", "--junit", "--html", "--csv"):
        path = getattr(asked, option.removeprefix("--"))
        if path is None:
            continue
        check_place(option, path)
        if str(path) == "-":  # the table goes there
            raise UsageError(f"{option} -: expected a file, found standard output")
        if other := taken.get(path.absolute()):
            raise UsageError(f"{option} {path}: expected a file of its own, found {other}")
        taken[path.absolute()] = f"the file of {option}"
        found.append((option, path))
    return found


def _form(option: str) -> Callable[[Judging], bytes]:
    """Return the function that makes a report; its libraries are loaded only if it is asked for."""
    if option == "--json":
        from judge.reports.schema import to_json

        return to_json
    if option == "--junit":
        from judge.reports.junit import to_junit

        return to_junit
    from judge.reports.html import to_html

    return to_html


def _write(option: str, path: Path, form: Callable[[Judging], bytes], judging: Judging) -> None:
    write_report(option, path, lambda: form(judging))


def _submission(asked: argparse.Namespace) -> Submission:
    from judge.languages.submission import (
        SubmissionError,
        from_source,
        read_source,
        read_submission,
    )
    from judge.languages.table import by_name

    language = None if asked.language is None else by_name(asked.language)
    if asked.submission == "":
        raise SubmissionError("expected a source file, found an empty name")
    if asked.submission not in (None, "-"):
        return read_submission(Path(asked.submission), language)
    return from_source(read_source(sys.stdin.buffer), "standard input", language)


def _parser() -> argparse.ArgumentParser:
    parser = Parser(
        prog="checker.py",
        description="Judge a submission: compile it, run it on every test case within the "
        "limits, compare its output with the answers.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("submission", nargs="?", help=SUBMISSION)
    add("--language", metavar="NAME", help="language (default: by suffix, else by the text)")
    add("--group", action="append", default=[], metavar="NAME", help="only this group; repeatable")
    add("--case", action="append", default=[], metavar="GLOB", help="only these cases; repeatable")
    add("--compact", action="store_true", help="only the small selection, data/compact.json")
    add("--data", type=Path, metavar="DIR", help="use the .in/.ans pairs of this directory")
    answers = "let the reference write the .ans files that are missing in --data DIR"
    add("--make-answers", action="store_true", help=answers)
    add_jobs(parser, cores(), "runs")
    add("--time-limit", type=_seconds, metavar="SECONDS", help="CPU seconds per case, not scaled")
    add("--json", type=Path, metavar="FILE", help="write the results as JSON")
    add("--junit", type=Path, metavar="FILE", help="write the results as JUnit XML")
    add("--html", type=Path, metavar="FILE", help="write the results as one page to look at")
    add("--csv", type=Path, metavar="FILE", help="write the scores of a whole class as a table")
    rest = parser.add_mutually_exclusive_group()
    rest.add_argument("--all", action="store_true", help="run the rest of a group after a failure")
    stop = "end each group at its first failure, as its points are all or nothing (the default)"
    rest.add_argument("--stop-on-first", action="store_true", help=stop)
    add("--verbose", action="store_true", help="show all that is kept of standard error")
    add("--no-wall", action="store_true", help="judge even if no wall works here")
    return parser


def _add_search(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--explain", action="store_true", help="show every missed lesson and a small counterexample"
    )
    parser.add_argument(
        "--seed", type=whole_number(0), metavar="N", help="--explain: search as the seed N did"
    )
    parser.add_argument(
        "--add", action="store_true", help="--explain: add the counterexample to data/"
    )


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value <= 3600:
        raise argparse.ArgumentTypeError(f"expected seconds in (0, 3600], found {text!r}")
    return value
