"""The keeper's side of the protocol.

One request per line on standard input, one reply per line on standard output, as `protocol`
encodes them. When standard input ends, even during a run, the judge is gone: the keeper kills
all processes and removes the scratch directory. The first reply says that the keeper is
ready, or why the scratch directory cannot be made.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path

from judge.sandbox.keeper.cgroup import Cgroup
from judge.sandbox.keeper.launch import LaunchError
from judge.sandbox.keeper.libc import LIBC
from judge.sandbox.keeper.protocol import (
    Facts,
    Failure,
    Request,
    decode_request,
    encode_reply,
)
from judge.sandbox.keeper.watch import CONTROL, JudgeGoneError, LeftError, run

PR_SET_CHILD_SUBREAPER = 36
HIGHEST_PRIORITY, NEVER_TO_BE_KILLED = "-20", "-1000"
BLOCK_BYTES = 1 << 16


def requests() -> Iterator[Request]:
    """Yield the requests until standard input ends."""
    pending = b""
    while block := os.read(CONTROL, BLOCK_BYTES):
        pending += block
        while b"\n" in pending:
            line, _, pending = pending.partition(b"\n")
            yield decode_request(line)


def answer(request: Request, cgroup: Cgroup) -> bool:
    """Reply to one request with the facts, or with a Failure; return whether to go on.

    A keeper with processes left would count them as the next program's.
    """
    reply: Facts | Failure
    try:
        reply = run(request, cgroup)
    except (LaunchError, LeftError) as error:
        reply = Failure(str(error), all_ended=isinstance(error, LaunchError))
    except OSError as error:
        reply = Failure(f"{error.filename or request.stdout}: {error.strerror}")
    os.write(1, encode_reply(reply))
    return reply.all_ended


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
    signal.signal(signal.SIGCHLD, signal.SIG_DFL)  # ignored, it would leave no child to wait for
    LIBC.prctl(PR_SET_CHILD_SUBREAPER, 1)
    # A fork bomb would starve a keeper of ordinary priority, and memory may run out. Only root
    # may prevent that; what it runs gets a session of its own, and ordinary values again.
    for file, value in (("autogroup", HIGHEST_PRIORITY), ("oom_score_adj", NEVER_TO_BE_KILLED)):
        with contextlib.suppress(OSError):
            Path("/proc/self", file).write_text(value)
    scratch = sys.argv[2]
    version, places = json.loads(sys.argv[3])
    cgroup = Cgroup(places, version)
    failed = make(scratch)
    try:
        os.write(1, encode_reply(None if failed is None else Failure(failed)))
        for request in requests():
            if not answer(request, cgroup):
                return  # the judge goes on with another keeper, and the scratch directory stays
    except (JudgeGoneError, BrokenPipeError):
        pass
    cgroup.close()
    # Imported here, because an earlier import would raise the smallest measurable peak memory.
    from judge.sandbox.keeper.remove import remove

    remove(scratch)
