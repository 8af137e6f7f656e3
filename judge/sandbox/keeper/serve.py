"""The keeper's side of the protocol.

One JSON object a line on standard input, one a line back on standard output; see
`watch.run`. The end of standard input, also in the middle of a run, means that the
judge is gone: everything is killed and the scratch directory is removed. The first
line back is `{"error": null}`, or why the scratch directory cannot be made.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from judge.sandbox.keeper.launch import LaunchError
from judge.sandbox.keeper.libc import LIBC
from judge.sandbox.keeper.watch import CONTROL, JudgeGoneError, run

PR_SET_CHILD_SUBREAPER = 36
BLOCK_BYTES = 1 << 16


def requests() -> Iterator[dict[str, Any]]:
    """Yield the requests until standard input ends."""
    pending = b""
    while block := os.read(CONTROL, BLOCK_BYTES):
        pending += block
        while b"\n" in pending:
            line, _, pending = pending.partition(b"\n")
            yield json.loads(line)


def answer(request: dict[str, Any]) -> None:
    """Serve one request: write the facts, or `{"error": why}`. Raises TimeoutError as `run`."""
    failed = None
    try:
        reply = run(request)
    except (LaunchError, OSError) as error:
        failed = error
        reply = {"error": str(error)}
    os.write(1, json.dumps(reply).encode() + b"\n")
    if isinstance(failed, TimeoutError):
        raise failed  # what is left would be counted with the next program


def make(scratch: str) -> str | None:
    """Make the scratch directory, which another keeper may have made; return what went wrong."""
    try:
        # Behind a wall, root's programs are another user's: let that walk through, see no names.
        Path(scratch).mkdir(mode=0o700 if os.getuid() else 0o711)
    except FileExistsError:
        return None
    except OSError as error:
        return error.strerror
    return None


def main() -> None:
    """Serve the judge until it is gone."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)  # the end of standard input is what ends the keeper
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)  # who ignores it is never told of an end
    LIBC.prctl(PR_SET_CHILD_SUBREAPER, 1)
    # Against a fork bomb that shares the processors fairly, the keeper would lose. Who may
    # not set this is held by RLIMIT_NPROC, which does not hold those who may.
    with contextlib.suppress(PermissionError):
        os.sched_setscheduler(0, os.SCHED_RR | os.SCHED_RESET_ON_FORK, os.sched_param(1))
    scratch = sys.argv[2]
    try:
        failed = make(scratch)
        os.write(1, json.dumps({"error": failed}).encode() + b"\n")
        for request in requests():
            answer(request)
    except (JudgeGoneError, BrokenPipeError, TimeoutError):
        pass
    # Only here: it would make every program's peak memory larger.
    from judge.sandbox.keeper.remove import remove

    remove(scratch)
