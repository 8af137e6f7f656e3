"""One Python program tried on many cases, in one child process made by a fork.

A fork costs about a millisecond, a new interpreter twenty. Thousands of mutants are tried on
dozens of small files, and most of these runs end at once. The programs are our own with one
change, not a stranger's, so they run under limits but in no sandbox.
"""

from __future__ import annotations

import io
import os
import resource
import select
import signal
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from types import CodeType
from typing import NoReturn

from judge.compare import compare
from judge.problem.cases import Case
from judge.problem.verdict import Verdict

_SILENCE_FACTOR = 20  # on a busy machine, a child may wait this many times its CPU limit
_MARKS = {b"W": Verdict.WA, b"R": Verdict.RTE}
_PAGE_BYTES = os.sysconf("SC_PAGE_SIZE")


@dataclass(frozen=True, slots=True)
class Kill:
    """The first case that a program fails, and how."""

    case: str
    verdict: Verdict


def first_kill(
    source: bytes, cases: Sequence[Case], time_limit_s: float, memory_mib: int
) -> Kill | None:
    """Run a program on the cases in order, up to the first that it fails; None if it fails none.

    time_limit_s: CPU seconds per case; memory_mib: address space beyond that of this
    process. Forks, so the caller must have one thread only. Leaves no child behind.
    """
    try:
        code = compile(source, "mutant", "exec")
    except (SyntaxError, ValueError):
        return Kill(cases[0].name, Verdict.CE)
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reader)
        _run_all(code, cases, time_limit_s, memory_mib, writer)
    os.close(writer)
    passed, mark = _listen(reader, child, time_limit_s * _SILENCE_FACTOR)
    os.close(reader)
    _, status = os.waitpid(child, 0)
    if passed == len(cases):
        return None
    timed_out = mark == b"T" or (
        os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGPROF, signal.SIGKILL)
    )
    verdict = Verdict.TLE if timed_out else _MARKS.get(mark, Verdict.RTE)
    return Kill(cases[passed].name, verdict)


def _listen(reader: int, child: int, silence_s: float) -> tuple[int, bytes]:
    """Return how many cases are passed, and the mark after that: empty if the child ended.

    A child that says nothing for `silence_s` seconds is killed; the mark is then T.
    """
    passed = 0
    while True:
        ready, _, _ = select.select([reader], [], [], silence_s)
        if not ready:
            os.kill(child, signal.SIGKILL)
            return passed, b"T"
        mark = os.read(reader, 1)
        if mark != b".":
            return passed, mark
        passed += 1


def _run_all(
    code: CodeType,
    cases: Sequence[Case],
    time_limit_s: float,
    memory_mib: int,
    writer: int,
) -> NoReturn:
    """In the child: run the cases, write a mark into the pipe after each, end the process."""
    try:
        signal.signal(signal.SIGPROF, signal.SIG_DFL)  # too much CPU time ends the child
        _limit_memory(memory_mib)
        for case in cases:
            content, answer = case.input.read_bytes(), case.answer.read_bytes()
            signal.setitimer(signal.ITIMER_PROF, time_limit_s)
            mark = _run(code, content, answer)
            signal.setitimer(signal.ITIMER_PROF, 0)
            os.write(writer, mark)
            if mark != b".":
                break
    finally:
        os._exit(0)


def _run(code: CodeType, content: bytes, answer: bytes) -> bytes:
    """Run the program on one input; return the mark of its result: `.` passed, W, or R."""
    sys.stdin = io.TextIOWrapper(io.BytesIO(content))
    printed = io.BytesIO()
    sys.stdout = io.TextIOWrapper(printed)
    sys.stderr = io.StringIO()
    try:
        exec(code, {"__name__": "__main__"})
    except BaseException as error:  # whatever a mutant raises
        if not (isinstance(error, SystemExit) and not error.code):
            return b"R"
    sys.stdout.flush()
    if printed.getvalue() == answer:
        return b"."
    printed.seek(0)
    return b"." if compare(printed, io.BytesIO(answer)) is None else b"W"


def _limit_memory(memory_mib: int) -> None:
    pages = int(Path("/proc/self/statm").read_text().split()[0])
    most = pages * _PAGE_BYTES + (memory_mib << 20)
    resource.setrlimit(resource.RLIMIT_AS, (most, most))
