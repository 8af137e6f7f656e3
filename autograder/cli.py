"""Judges what a student handed in: `python -m autograder /autograder`.

Whatever happens, results/results.json is there at its end, complete. A fault of what was handed in
costs the points; a fault of the judge gives no score, and says so to the instructor.
"""

from __future__ import annotations

import os
import sys
import time
import traceback
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from autograder.results import broken, judged, refused
from autograder.source import handed_in
from judge.feedback import told
from judge.judging import Options, judge
from judge.kit.command import Parser, complain, run
from judge.kit.console import PlainConsole
from judge.kit.errors import KitError
from judge.kit.files import write_whole
from judge.kit.processors import cores
from judge.languages.submission import Submission, SubmissionError
from judge.languages.table import LanguageError
from judge.problem.declaration import Problem, load
from judge.problem.verdict import Verdict
from judge.reports.terminal import print_report
from judge.results import Judging
from judge.sandbox.keeper.launch import open_to_all
from stress.front import illustrate, make_search, measure

DONE, FAILED = 0, 2
PLACE = Path("/autograder")
OURS = ("source", "submission", "results")
OWN_USERS = (
    "no wall works in this container; programs run as users of their own, who cannot enter "
    "source/, submission/ and results/, but can use the network"
)


class JudgeFailedError(KitError):
    """A run failed for a fault of the machine or of the judge."""


def main(arguments: Sequence[str]) -> int:
    """Judge, and write results.json. Return the exit status: 0 done, 2 if the judge failed."""
    parser = Parser(prog="python -m autograder", description=__doc__)
    parser.add_argument("place", nargs="?", type=Path, default=PLACE, help=f"({PLACE})")
    return run("autograder", lambda: _command(parser.parse_args(arguments).place.resolve()))


def _command(place: Path) -> int:
    status = DONE
    try:
        content = _content(place)
    except Exception as error:  # the boundary: a student never pays for a fault of the kit
        known = str(error) if isinstance(error, KitError) else traceback.format_exc()
        complain(f"autograder: the judge failed: {known}")
        content, status = broken(known), FAILED
    write_whole(place / "results" / "results.json", content, parents=True)
    return status


def _content(place: Path) -> bytes:
    """Return the content of results.json. Raises KitError if the judge fails."""
    began = time.monotonic()
    close_to_others(place)
    problem = load()
    try:
        submission = handed_in(place / "submission")
    except (SubmissionError, LanguageError) as error:
        print(f"not judged: {error}")
        return refused(str(error), problem.groups)
    judging = _judging(submission, problem)
    permitted = told(judging, problem.feedback)
    if permitted.diagnosis is not None:
        permitted = replace(permitted, diagnosis=illustrate(permitted.diagnosis))
    return judged(permitted, time.monotonic() - began)


def _judging(submission: Submission, problem: Problem) -> Judging:
    """Judge a submission; print all about it, for the instructor. Raises KitError."""
    options = Options(jobs=cores(), no_wall=True)
    search = make_search(None, False)
    judging = judge(submission, problem, options, search=search, measure=measure)
    print_report(PlainConsole(), judging)
    if judging.wall is None and os.getuid() == 0 and open_to_all(os.path.realpath(sys.executable)):
        print(OWN_USERS)
    failed = next((result for result in judging.cases if result.verdict is Verdict.JE), None)
    if failed is not None:
        raise JudgeFailedError(f"{failed.case.name}: {failed.message}")
    return judging


def close_to_others(place: Path) -> None:
    """Let only this user enter the directories with answers and results, if it is root.

    Root's programs run as users of their own, with a wall or without.
    """
    if os.getuid() == 0:
        for name in OURS:
            if (place / name).is_dir():
                (place / name).chmod(0o700)
