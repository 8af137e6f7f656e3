"""The keeper's side of the protocol.

One request a line on standard input, one reply a line on standard output, as `protocol`
encodes them. When standard input ends, also in the middle of a run, the judge is gone:
everything is killed and the scratch directory is removed. The first reply says that the
keeper is ready, or why the scratch directory cannot be made.
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
    """Serve one request: write the facts, or why there are none. Raises TimeoutError as `run`."""
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
        raise failed  # its processes would be counted with those of the next program


def make(scratch: str) -> str | None:
    """Make the scratch directory, which another keeper may have made; return what went wrong."""
    try:
        # Behind a wall, root's programs run as another user, who may pass through but not list.
        Path(scratch).mkdir(mode=0o700 if os.getuid() else 0o711)
    except FileExistsError:
        return None
    except OSError as error:
        return error.strerror or str(error)
    return None


def main() -> None:
    """Serve the judge until it is gone."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)  # the end of standard input is what ends the keeper
    signal.signal(
        signal.SIGCHLD, signal.SIG_DFL
    )  # with SIGCHLD ignored, no child could be waited for
    LIBC.prctl(PR_SET_CHILD_SUBREAPER, 1)
    # A fork bomb that shares the processors fairly would starve the keeper. Only root may set
    # this; other users' programs are held by RLIMIT_NPROC, which does not hold root.
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
    # Imported only here: it would make the least peak memory of every program larger.
    from judge.sandbox.keeper.remove import remove

    remove(scratch)
