"""A keeper process as the judge sees it: one request in, its facts out."""

from __future__ import annotations

import contextlib
import json
import select
import subprocess
import sys
import time
from functools import cache
from pathlib import Path

from judge.kit.errors import KitError
from judge.kit.paths import ROOT
from judge.sandbox.facts import STARVED_AT_MOST_S, Facts
from judge.sandbox.keeper import BOOT
from judge.sandbox.keeper.cgroup import Cgroups
from judge.sandbox.keeper.protocol import Request, decode_reply, encode

ANSWER_MARGIN_S = 30.0  # extra time for a reply before the keeper counts as lost
END_TIMEOUT_S = 15.0
NOBODY = 65534
FIRST_USER = 2_000_000_000  # no machine gives such numbers to people or services


class SandboxError(KitError):
    """The run could not be made or watched; that is not the program's fault."""


class LostKeeperError(SandboxError):
    """The keeper of the run is gone, and with it what it saw."""


class Keeper:
    """One keeper process and the two pipes to it. It starts in the background."""

    def __init__(self, scratch: Path, cgroups: Cgroups) -> None:
        places = {use: f"{place}/{scratch.name}" for use, place in cgroups.places.items()}
        process = subprocess.Popen(
            [sys.executable, "-I", "-S", "-c", BOOT, str(ROOT), str(scratch), json.dumps(places)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env={},
            cwd="/",
            start_new_session=True,  # Ctrl-C must reach only the judge
        )
        assert process.stdin is not None
        assert process.stdout is not None
        self._process, self._requests, self._replies = process, process.stdin, process.stdout

    @property
    def user(self) -> int:
        """Whom root becomes to run programs: a user of this keeper's own, with own quotas."""
        return FIRST_USER + self._process.pid if _all_users_exist() else NOBODY

    def alive(self) -> bool:
        """Tell whether the process is running."""
        return self._process.poll() is None

    def ask(self, request: Request) -> Facts:
        """Send one request and wait for the reply. Raises SandboxError; then the keeper is lost."""
        longest_s = request.limits.kill_elapsed_s + STARVED_AT_MOST_S + ANSWER_MARGIN_S
        give_up = time.monotonic() + longest_s
        line = b""
        with contextlib.suppress(OSError, ValueError):  # closed by hang_up in another thread
            self._requests.write(encode(request))
            self._requests.flush()
            # One second at a time: Python handles a signal only between two waits.
            while not select.select([self._replies], [], [], 1.0)[0]:
                if time.monotonic() > give_up:
                    raise TimeoutError
            line = self._replies.readline()
        if not line:
            raise LostKeeperError("the keeper of the run was lost")
        reply = decode_reply(line)
        if isinstance(reply, str):
            raise SandboxError(reply)
        return reply

    def hang_up(self) -> None:
        """Close the control pipe, which makes the keeper stop its run and exit."""
        with contextlib.suppress(OSError):  # an unsent request: the keeper has exited
            self._requests.close()

    def end(self) -> None:
        """Hang up and wait until the keeper exits; kill it if it does not."""
        self.hang_up()
        try:
            self._process.wait(timeout=END_TIMEOUT_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._replies.close()


@cache
def _all_users_exist() -> bool:
    """Tell whether every number is a user here; in many containers only the first 65,536 are."""
    last = [line.split() for line in Path("/proc/self/uid_map").read_text().splitlines()][-1]
    return int(last[0]) + int(last[2]) > 2 * FIRST_USER
