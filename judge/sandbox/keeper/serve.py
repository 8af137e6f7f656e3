"""The keeper's side of the protocol.

Requests come on standard input, replies go to standard output. When standard input ends, even
during a run, the judge is gone: the keeper kills all processes and removes the scratch directory.
After a run that could not be made, or that has not ended, it only exits: processes left would
count as the next program's.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import sys
from pathlib import Path

from judge.sandbox.facts import Facts
from judge.sandbox.keeper.cgroup import Cgroup
from judge.sandbox.keeper.launch import Launched, RunError, launch
from judge.sandbox.keeper.proc import LIBC
from judge.sandbox.keeper.protocol import Request, decode_request, encode
from judge.sandbox.keeper.tree import Tree
from judge.sandbox.keeper.watch import JudgeGoneError, run

PR_SET_CHILD_SUBREAPER = 36
HIGHEST_PRIORITY, NEVER_TO_BE_KILLED = "-20", "-1000"


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
    cgroup = Cgroup(json.loads(sys.argv[3]))
    try:
        if not serve(cgroup):
            return  # the judge goes on with another keeper, and the scratch directory stays
    except (JudgeGoneError, BrokenPipeError):
        pass
    finally:
        cgroup.close()
    # Imported here, because an earlier import would raise the smallest measurable peak memory.
    from judge.sandbox.keeper.remove import remove

    remove(scratch)


def serve(cgroup: Cgroup) -> bool:
    """Carry out requests, building walls ahead; return whether all were, up to the last one."""
    last: Request | None = None
    ahead: Launched | None = None
    for line in sys.stdin.buffer:
        request = decode_request(line)
        command = request._replace(stdin=None, stdout="")
        if ahead and (command != last or ahead.ended):
            discard(ahead, cgroup)
            ahead = None
        reply: Facts | str
        try:
            reply = run(request, ahead, cgroup)
        except RunError as error:
            reply = str(error)
        except OSError as error:
            reply = f"{error.filename or request.stdout}: {error.strerror}"
        os.write(1, encode(reply))
        if isinstance(reply, str) or not reply.all_ended:
            return False
        ahead = None
        if request.wall and command == last:
            with contextlib.suppress(RunError):  # the next run will tell
                ahead = launch(command)
        last = command
    if ahead:
        discard(ahead, cgroup)
    return True


def discard(launched: Launched, cgroup: Cgroup) -> None:
    """End a wall whose program was not needed."""
    Tree({}, cgroup).end()
    launched.close()
