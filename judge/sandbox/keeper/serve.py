"""The keeper's side of the protocol.

One request per line on standard input, one reply per line on standard output, as `protocol`
encodes them. When standard input ends, even during a run, the judge is gone: the keeper kills
all processes and removes the scratch directory. The first reply says that the keeper is
ready, or why the scratch directory cannot be made.
"""

from __future__ import annotations

import contextlib
import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path

from judge.sandbox.keeper.launch import LaunchError
from judge.sandbox.keeper.libc import LIBC
from judge.sandbox.keeper.protocol import (
    Facts,
    Failure,
    Request,
    decode_request,
    encode_reply,
)
from judge.sandbox.keeper.watch import CONTROL, JudgeGoneError, run

PR_SET_CHILD_SUBREAPER = 36
BLOCK_BYTES = 1 << 16


def requests() -> Iterator[Request]:
    """Yield the requests until standard input ends."""
    pending = b""
    while block := os.read(CONTROL, BLOCK_BYTES):
        pending += block
        while b"\n" in pending:
            line, _, pending = pending.partition(b"\n")
            yield decode_request(line)


def answer(request: Request) -> None:
    """Reply to one request with the facts, or with a Failure. Raises TimeoutError, see `run`."""
    reply: Facts | Failure
    failed = None
    try:
        reply = run(request)
    except LaunchError as error:
        reply = Failure(str(error))
    except TimeoutError as error:
        failed = error
        reply = Failure(str(error))
    except OSError as error:
        reply = Failure(f"{error.filename or request.stdout}: {error.strerror}")
    os.write(1, encode_reply(reply))
    if failed is not None:
        raise failed  # the processes that are left would count as the next program's


def make(scratch: str) -> str | None:
    """Make the scratch directory unless another keeper has; return an error message or None."""
    try:
        # Root's programs run as another user, who must be able to enter but not to list it.
        Path(scratch).mkdir(mode=0o700 if os.getuid() else 0o711)
    except FileExistsError:
        return None
    except OSError as error:
        return error.strerror or str(error)
    return None


def main() -> None:
    """Serve the judge until it is gone."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)  # only the end of standard input ends the keeper
    signal.signal(
        signal.SIGCHLD, signal.SIG_DFL
    )  # with SIGCHLD ignored, no child could be waited for
    LIBC.prctl(PR_SET_CHILD_SUBREAPER, 1)
    # A fork bomb would starve a keeper of ordinary priority. Only root may raise it; programs
    # of other users are limited by RLIMIT_NPROC, which does not bind root.
    with contextlib.suppress(PermissionError):
        os.sched_setscheduler(0, os.SCHED_RR | os.SCHED_RESET_ON_FORK, os.sched_param(1))
    scratch = sys.argv[2]
    try:
        failed = make(scratch)
        os.write(1, encode_reply(None if failed is None else Failure(failed)))
        for request in requests():
            answer(request)
    except (JudgeGoneError, BrokenPipeError, TimeoutError):
        pass
    # Imported here, because an earlier import would raise the smallest measurable peak memory.
    from judge.sandbox.keeper.remove import remove

    remove(scratch)
