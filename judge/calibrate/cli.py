"""`make calibrate`, or `python -m judge.calibrate`: measure the margins of the time limit.

It also deletes the kept scale of this machine, so the next judging that needs the scale
measures it again.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence
from functools import partial

from rich.table import Table

from judge.calibrate.margins import Margins, Time, margins, measure
from judge.judging import JudgeError
from judge.kit.command import Parser, run
from judge.kit.console import PlainConsole
from judge.kit.files import write_whole
from judge.kit.paths import PROBLEM_FILE
from judge.kit.store import Store
from judge.machine import forget_scale, reference_cpu_s
from judge.problem.data import load_data
from judge.problem.declaration import Problem, load
from judge.sandbox.probe import walled_sandbox


def written(text: str, limit_s: float, reference_s: float) -> str:
    r"""Return the text of problem.toml with both figures replaced and nothing else changed.

    >>> written("time_limit_s = 5.0  # why\\nreference_cpu_s = 1.0\\n", 4.5, 0.25)
    'time_limit_s = 4.5  # why\\nreference_cpu_s = 0.25\\n'
    """
    for key, value in (("time_limit_s", limit_s), ("reference_cpu_s", reference_s)):
        text, found = re.subn(rf"(?m)^({key}\s*=\s*)[\d._]+", rf"\g<1>{value}", text)
        if found != 1:
            raise JudgeError(f"problem.toml: expected one line `{key} = …`, found {found}")
    return text


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; return 0 when a limit fits, 1 when none does, 2 on an error."""
    parser = Parser(
        prog="python -m judge.calibrate", description="Measure the margins of the time limit."
    )
    parser.add_argument("--write", action="store_true", help="write the figures to problem.toml")
    parser.add_argument(
        "--only", metavar="TEXT", default="", help="only submissions whose name contains TEXT"
    )
    command = partial(_calibrate, parser, arguments)
    return run("calibrate", command, interrupted="interrupted, nothing was written")


def _calibrate(parser: argparse.ArgumentParser, arguments: Sequence[str] | None) -> int:
    asked = parser.parse_args(arguments)
    only, write = asked.only, asked.write
    problem = load()
    names = [
        name
        for name in problem.submissions
        if name.startswith(("accepted/", "time_limit_exceeded/")) and only in name
    ]
    if not names:
        raise JudgeError(f"--only {only!r}: expected part of a name of an accepted or slow one")
    with Store() as store:
        cases = load_data(problem, store=store).chosen
    console = PlainConsole()
    forget_scale()  # the next judging that needs it measures this machine again
    with walled_sandbox(without_wall=True) as sandbox:
        reference_s = round(reference_cpu_s(problem, sandbox), 2)
        console.print(f"reference on {problem.calibration.case}: {reference_s} s of CPU time")
        times = [
            time
            for name in names
            for time in measure(name, problem, cases, sandbox, lambda t: console.print(_line(t)))
        ]
    found = margins(times, problem)
    declared_s = problem.limits.time_limit_s
    console.print(_table(found, declared_s, problem))
    proposal_s = found.proposal(declared_s)
    if proposal_s is None:
        console.print("no limit keeps both margins: the data must make the slow submissions slower")
        return 1
    console.print(f"time_limit_s = {proposal_s}, reference_cpu_s = {reference_s}")
    if write and not only:
        text = written(PROBLEM_FILE.read_text(), proposal_s, reference_s)
        write_whole(PROBLEM_FILE, text.encode())
        load()
        console.print("problem.toml is written; change the limit in problem.md by hand")
    return 0


def _line(time: Time) -> str:
    least = "≥" if time.at_least else " "
    return f"{time.expected:4}{least}{time.cpu_s:6.2f} s  {time.submission}  {time.case}"


def _table(found: Margins, declared_s: float, problem: Problem) -> Table:
    asked = problem.limits.time_multipliers
    table = Table(show_edge=False)
    for heading in ("", "CPU s", "ratio", "asked", "submission", "case"):
        table.add_column(heading, overflow="fold")
    slowest, fastest = found.slowest, found.fastest
    table.add_row(
        "slowest AC",
        f"{slowest.cpu_s:.2f}",
        f"{declared_s / slowest.cpu_s:.2f}",
        f"{asked.ac_to_time_limit:.2f}",
        slowest.submission,
        slowest.case,
    )
    table.add_row("limit", f"{declared_s:.2f}")
    if fastest is not None:
        least = "≥ " if fastest.at_least else ""
        table.add_row(
            "fastest TLE",
            f"{least}{fastest.cpu_s:.2f}",
            f"{least}{fastest.cpu_s / declared_s:.2f}",
            f"{asked.time_limit_to_tle:.2f}",
            fastest.submission,
            fastest.case,
        )
    return table
