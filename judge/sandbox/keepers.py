"""A keeper process as the judge sees it: one request in, its facts out."""

from __future__ import annotations

import select
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from judge.kit.errors import KitError
from judge.kit.paths import ROOT
from judge.sandbox.keeper import BOOT
from judge.sandbox.keeper.protocol import (
    Facts,
    Failure,
    Request,
    decode_reply,
    encode_request,
)

ANSWER_MARGIN_S = 30.0  # what a keeper may need beyond the limits before it is given up
END_TIMEOUT_S = 15.0


class SandboxError(KitError):
    """The run could not be made or watched; the program is not to blame."""


class LostKeeperError(SandboxError):
    """The keeper of the run is gone, and with it what it saw."""

    def __init__(self, message: str = "the keeper of the run was lost") -> None:
        super().__init__(message)


class Keeper:
    """One keeper process, and the two pipes to it. It starts while others go on; see `ready`."""

    def __init__(self, scratch: Path) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-I", "-S", "-c", BOOT, str(ROOT), str(scratch)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env={},
            cwd="/",
            start_new_session=True,  # Ctrl-C is the judge's to handle
        )
        self._scratch = scratch
        self._ready = False

    def ready(self) -> None:
        """Wait until the keeper and its scratch directory are there. Raises SandboxError."""
        if not self._ready:
            answer = self._reply(ANSWER_MARGIN_S)
            if isinstance(answer, Failure):
                raise SandboxError(f"{self._scratch.parent}: no scratch space: {answer.why}")
            self._ready = True

    def alive(self) -> bool:
        """Tell whether the process is there."""
        return self._process.poll() is None

    def ask(self, request: Request) -> Facts | Failure:
        """Send one request and wait for what came of it. SandboxError: the keeper is of no use."""
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
                # A second at a time, so that no signal that came just before is missed.
                ready, _, _ = select.select([stdout], [], [], min(left_s, 1.0))
            line = stdout.readline() if ready else b""
        except (OSError, ValueError):
            line = b""
        if not line:
            raise LostKeeperError
        return decode_reply(line)

    def hang_up(self) -> None:
        """Close the control pipe: the keeper ends its run and itself."""
        if self._process.stdin is not None:
            try:
                self._process.stdin.close()
            except OSError:
                return  # a request that could not be written: the keeper is gone already

    def end(self) -> None:
        """Hang up and wait for the end, which is forced if it does not come."""
        self.hang_up()
        try:
            self._process.wait(timeout=END_TIMEOUT_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        if self._process.stdout is not None:
            self._process.stdout.close()
