"""A keeper process as the judge sees it: one request in, its facts out."""

from __future__ import annotations

import json
import select
import subprocess
import sys
import time
from functools import cache
from pathlib import Path
from typing import Any

from judge.kit.errors import KitError
from judge.kit.paths import ROOT
from judge.sandbox.cgroups import Cgroups
from judge.sandbox.keeper import BOOT
from judge.sandbox.keeper.protocol import (
    Facts,
    Failure,
    Request,
    decode_reply,
    encode_request,
)

ANSWER_MARGIN_S = 30.0  # extra time for a reply before the keeper counts as lost
END_TIMEOUT_S = 15.0
NOBODY = 65534
FIRST_USER = 2_000_000_000  # no machine gives such numbers to people or services


class SandboxError(KitError):
    """The run could not be made or watched; that is not the program's fault."""


class LostKeeperError(SandboxError):
    """The keeper of the run is gone, and with it what it saw."""

    def __init__(self, message: str = "the keeper of the run was lost") -> None:
        super().__init__(message)


class Keeper:
    """One keeper process and the two pipes to it. It starts in the background; see `ready`."""

    def __init__(self, scratch: Path, cgroups: Cgroups) -> None:
        places = cgroups.version, {u: f"{p}/{scratch.name}" for u, p in cgroups.places.items()}
        self._process = subprocess.Popen(
            [sys.executable, "-I", "-S", "-c", BOOT, str(ROOT), str(scratch), json.dumps(places)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env={},
            cwd="/",
            start_new_session=True,  # Ctrl-C must reach only the judge
        )
        self._scratch = scratch
        self._ready = False

    def ready(self) -> None:
        """Wait until the keeper runs and its scratch directory exists. Raises SandboxError."""
        if not self._ready:
            answer = self._reply(ANSWER_MARGIN_S)
            if isinstance(answer, Failure):
                raise SandboxError(f"{self._scratch.parent}: no scratch space: {answer.why}")
            self._ready = True

    @property
    def user(self) -> int:
        """Whom root becomes to run programs: a user of this keeper's own, with own quotas."""
        return FIRST_USER + self._process.pid if _all_users_exist() else NOBODY

    def alive(self) -> bool:
        """Tell whether the process is running."""
        return self._process.poll() is None

    def ask(self, request: Request) -> Facts | Failure:
        """Send one request and wait for the reply. Raises SandboxError if the keeper is lost."""
        self.ready()
        stdin = self._process.stdin
        assert stdin is not None
        try:
            stdin.write(encode_request(request))
            stdin.flush()
        except (OSError, ValueError):  # ValueError: closed by hang_up in another thread
            raise LostKeeperError from None
        reply = self._reply(request.kill_elapsed_s + ANSWER_MARGIN_S)
        if reply is None:
            raise LostKeeperError
        return reply

    def _reply(self, timeout_s: float) -> Facts | Failure | None:
        stdout = self._process.stdout
        assert stdout is not None
        try:
            ready: list[Any] = []
            give_up = time.monotonic() + timeout_s
            while not ready and (left_s := give_up - time.monotonic()) > 0:
                # One second at a time: Python handles a signal only between two waits.
                ready, _, _ = select.select([stdout], [], [], min(left_s, 1.0))
            line = stdout.readline() if ready else b""
        except (OSError, ValueError):
            line = b""
        if not line:
            raise LostKeeperError
        return decode_reply(line)

    def hang_up(self) -> None:
        """Close the control pipe, which makes the keeper stop its run and exit."""
        if self._process.stdin is not None:
            try:
                self._process.stdin.close()
            except OSError:
                return  # an unsent request cannot be written: the keeper has exited

    def end(self) -> None:
        """Hang up and wait until the keeper exits; kill it if it does not."""
        self.hang_up()
        try:
            self._process.wait(timeout=END_TIMEOUT_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        if self._process.stdout is not None:
            self._process.stdout.close()


@cache
def _all_users_exist() -> bool:
    """Tell whether every number is a user here; in many containers only the first 65,536 are."""
    last = [line.split() for line in Path("/proc/self/uid_map").read_text().splitlines()][-1]
    return int(last[0]) + int(last[2]) > 2 * FIRST_USER
