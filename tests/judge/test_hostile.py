"""Hostile programs: each gets an expected verdict, gains nothing, and leaves nothing.

`hostile/` attacks the judge at run time, `hostile/compile/` attacks the compiler. The first line
of each program says what it does and, after `Expect:`, which verdicts are right. A program that
tries to gain something answers right only if it succeeds, so WA means that it did not.
"""

from __future__ import annotations

import ctypes
import io
import os
import re
import shutil
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import msgspec
import pytest
from rich.console import Console

from judge.judging import Options, judge
from judge.languages.submission import read_submission
from judge.languages.table import by_suffix
from judge.problem.declaration import Feedback, Problem, load
from judge.problem.verdict import Verdict
from judge.reports.junit import to_junit
from judge.reports.schema import to_json
from judge.reports.terminal import case_line, print_report
from judge.results import Judging
from judge.sandbox.keeper.proc import children
from judge.sandbox.wall import Wall

HERE = Path(__file__).parent / "hostile"
PROGRAMS = sorted(path for path in HERE.rglob("*.*") if by_suffix(path))
SLOW = {  # only with a diagnosis, in a slow test; for each, a fast test has one of its kind
    *("drips.py", "stops_itself.py"),  # sleeps.py
    *("memory_in_many_tables.c", "memory_in_sparse_tables.c"),  # memory_in_tables.c
    *("memory_lent.c", "memory_in_tmpfs.py"),  # memory_shared.c, memory_in_memfd.py
    *("fills_the_inodes.py", "floods_stdout.c"),  # fills_the_disk.py, floods_stderr.c
    *("forks_slowly.py", "template_bomb.cpp"),  # forks_fast.c, macro_bomb.c
    *("burns_unreadable.c", "leaves_zombies.py"),  # burns_in_unseen_children.py, leaves_daemons.py
    *("right_then_flood.py", "right_then_status.py"),  # floods_stderr.c, right_then_crash.c
    *("escapes.py", "status_139.py"),  # escapes_in_output.py, kills_itself.py
    *("looks_for_earlier_runs.py", "sparse_file.py"),  # looks_for_answers.py, fills_the_disk.py
    *("memory_in_sockets.c", "memory_of_one.c"),  # memory_in_pipes.c, memory_of_many.c
    *("includes_accounts.c", "escapes_in_source.py3"),  # includes_input.c, error_flood.c
    *("aborts.c", "forks_relay.c"),  # stack_overflow.c, forks_fast.c
}
SECONDS_AT_MOST = 30  # elapsed, for one program on a busy machine
PR_SET_CHILD_SUBREAPER = 36

_declared = load()
PROBLEM = msgspec.structs.replace(
    _declared,
    limits=msgspec.structs.replace(
        _declared.limits, compilation_time_s=2.0, compilation_memory_mib=400
    ),
)
# The fast tests judge without a diagnosis, which runs the program again, in the same sandbox.
QUIET = msgspec.structs.replace(PROBLEM, feedback=Feedback(tell="verdict", name_secret_cases=True))
DATA = {"sample/01": "YES\n", "sample/02": "NO\nYES\n"}


def expected(path: Path) -> set[str]:
    found = re.search(r"Expect: ([A-Z ]+)", path.read_text("utf-8").partition("\n")[0])
    assert found, f"{path}: the first line must say `Expect:`"
    return set(found[1].split())


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Path:
    directory = tmp_path_factory.mktemp("hostile") / "data"
    for name, text in DATA.items():
        for ending in (".in", ".ans"):
            path = directory / (name + ending)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
    return directory


@pytest.fixture(autouse=True)
def nothing_is_left(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, data: Path, wall: Wall
) -> Iterator[None]:
    """Adopt every process that outlives its keeper, so that it is found."""
    assert wall
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    before = set(children(os.getpid()))
    yield
    assert set(children(os.getpid())) <= before, "processes were left"
    assert list(tmp_path.iterdir()) == [], "files were left"
    texts = {p.relative_to(data).as_posix(): p.read_text() for p in data.rglob("*.*")}
    assert texts == {n + e: t for n, t in DATA.items() for e in (".in", ".ans")}


def shown(judging: Judging) -> str:
    """Return all that a person or another program would see of a judging."""
    screen = io.StringIO()
    console = Console(file=screen, highlight=False, color_system=None, width=200)
    for result in judging.cases:
        console.print(case_line(result), soft_wrap=True)
    print_report(console, judging)
    return screen.getvalue() + to_json(judging).decode() + to_junit(judging).decode()


@pytest.mark.parametrize(
    "path",
    [path for path in PROGRAMS if path.name not in SLOW],
    ids=lambda path: path.relative_to(HERE).as_posix(),
)
def test_the_verdict_is_an_expected_one(path: Path, data: Path) -> None:
    check_verdict(path, data, QUIET)


@pytest.mark.slow
@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.relative_to(HERE).as_posix())
def test_a_diagnosis_changes_no_verdict_and_stays_short(path: Path, data: Path) -> None:
    check_verdict(path, data, PROBLEM)


def check_verdict(path: Path, data: Path, problem: Problem) -> None:
    """Judge a program; its verdict, its time and the reports must be as they should."""
    tool = {".c": "gcc", ".cpp": "g++"}.get(path.suffix)
    if tool is not None and shutil.which(tool) is None:
        pytest.skip(f"{tool} is not installed")
    started = time.monotonic()
    # Short where only the time limit ends the program; otherwise long, so that a busy machine
    # does not decide the verdict.
    time_limit_s = 0.6 if "TLE" in expected(path) else 3.0
    options = Options(data=data, time_limit_s=time_limit_s, stop_on_first=True)
    judging = judge(read_submission(path), problem, options)
    assert time.monotonic() - started < SECONDS_AT_MOST
    text = shown(judging)
    assert judging.verdict.value in expected(path), text
    assert judging.wall is not None
    assert all(c.isprintable() or c == "\n" for c in text), "unprintable characters are shown"
    own = shown(replace(judging, diagnosis=None))  # the lessons are the kit's words, not its
    assert len(own) < 9000, "a report stays short"


def test_no_hostile_program_is_lost() -> None:
    """A rename or a merge could lose some."""
    assert len(PROGRAMS) >= 55
    every = {verdict for path in PROGRAMS for verdict in expected(path)}
    assert every == set(Verdict) - {Verdict.JE}
