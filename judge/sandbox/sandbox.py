"""Runs programs through keepers: one command in, its facts out."""

from __future__ import annotations

import json
import os
import secrets
import select
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from signal import SIGKILL
from types import TracebackType
from typing import Any, Self

from judge.kit.errors import KitError
from judge.kit.paths import ROOT
from judge.sandbox.cgroups import Groups
from judge.sandbox.facts import Facts, RunLimits, Stop
from judge.sandbox.keeper import BOOT
from judge.sandbox.keeper.remove import remove
from judge.sandbox.keeper.wall import NOBODY, open_to_all
from judge.sandbox.wall import PROGRAM, SCRATCH, Wall

ANSWER_MARGIN_S = 30.0  # what a keeper may need beyond the wall limit before it is given up
FILE_MIB = 256  # the largest file a run may write into its scratch directory


LOST = "the keeper of the run was lost"
KILLED = 128 + SIGKILL  # as a wall, or a shell, passes it on


class SandboxError(KitError):
    """The run could not be made or watched; the program is not to blame."""


@dataclass(frozen=True, slots=True)
class Command:
    """What to execute.

    argv[0]: an absolute path, as seen from within; env: the whole environment but for
    HOME and TMPDIR; directory: the program's own, which a wall shows and nothing else of
    ours; prefixes: directories outside the system that the tools of its language live in.
    """

    argv: tuple[str, ...]
    env: Mapping[str, str] = field(default_factory=dict)
    directory: Path | None = None
    prefixes: tuple[str, ...] = ()


class Sandbox:
    """A pool of keepers and a scratch directory, both gone when it is closed.

    Any number of threads may call `run` at once; each run has a keeper to itself.
    The keepers make the scratch directory, and remove it when this process dies, however
    it does. Raises SandboxError if there is no place for it.
    """

    def __init__(self, wall: Wall | None = None) -> None:
        self.wall = wall
        self._groups = Groups()
        name = f"collision-course-{secrets.token_hex(8)}"
        self.scratch = Path(tempfile.gettempdir()).resolve() / name
        try:
            first = _Keeper(self.scratch)
        except BaseException:  # it may have been killed just after it made the directory
            self._groups.close(name)
            remove(self.scratch)
            raise
        self._idle = [first]
        self._all = [first]
        self._lock = threading.Lock()
        self._closed = False

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def run(
        self,
        command: Command,
        limits: RunLimits,
        *,
        stdout: Path,
        stdin: Path | None = None,
        compiling: bool = False,
    ) -> Facts:
        """Run `command` to its end and return what was seen; no process of it remains.

        stdin: file fed through a pipe, None for an empty one. stdout: file that
        receives at most `limits.output_bytes`. It runs in an empty directory that is
        gone afterwards; compiling: it may write to `command.directory`.
        What is ended by a SIGKILL that is not the keeper's is run once more: the kernel,
        out of memory, or a person may have sent it. Raises SandboxError.
        """
        facts = self._run(command, limits, stdin, stdout, compiling)
        if facts.stopped is None and (facts.signal == SIGKILL or facts.exit_status == KILLED):
            facts = self._run(command, limits, stdin, stdout, compiling)
        return facts

    def _run(
        self,
        command: Command,
        limits: RunLimits,
        stdin: Path | None,
        stdout: Path,
        compiling: bool,
    ) -> Facts:
        own, wall, home, drop = None, None, SCRATCH, False
        if self.wall is None:
            own = home = self.new_directory("run-")
            drop = os.getuid() == 0 and self._open_to_all(command)
            if drop:
                os.chown(own, NOBODY, NOBODY)
        else:
            wall = self.wall.request(
                command.directory, writable=compiling, prefixes=command.prefixes
            )
        request = {
            "argv": command.argv,
            "env": {**command.env, "HOME": str(home), "TMPDIR": str(home)},
            "cwd": "/" if own is None else str(own),
            "drop": drop,
            "wall": wall,
            "group": self._groups.request(self.scratch.name),
            "stdin": None if stdin is None else str(stdin),
            "stdout": str(stdout),
            "kill_cpu_s": limits.kill_cpu_s,
            "kill_wall_s": limits.kill_wall_s,
            "memory_mib": limits.memory_mib,
            "output_bytes": limits.output_bytes,
            "processes": limits.processes,
            "file_mib": FILE_MIB,
        }
        keeper = self._take()
        try:
            reply = keeper.ask(request, limits.kill_wall_s + ANSWER_MARGIN_S)
        except BaseException:
            keeper.end()
            raise
        else:
            self._give_back(keeper)
        finally:
            if own is not None:
                remove(own)
        if "error" in reply:
            raise SandboxError(reply["error"])
        reply["stopped"] = None if reply["stopped"] is None else Stop(reply["stopped"])
        reply["stderr"] = reply["stderr"].encode("latin-1")
        return Facts(**reply)

    def inside(self, directory: Path) -> Path:
        """Return where a program's `directory` appears to the program."""
        return directory if self.wall is None else PROGRAM

    def new_program_directory(self) -> Path:
        """Return an empty directory that a compiler behind the wall may write to."""
        directory = self.new_directory("program-")
        directory.chmod(0o755)
        if os.getuid() == 0:
            os.chown(directory, NOBODY, NOBODY)
        return directory

    def _open_to_all(self, command: Command) -> bool:
        """May every user walk to what the command needs?"""
        needed = (os.path.realpath(command.argv[0]), *command.prefixes, f"{self.scratch}/run")
        try:
            return all(map(open_to_all, needed))
        except OSError:  # it is not there, as will be said soon enough
            return False

    def new_directory(self, prefix: str) -> Path:
        """Return an empty directory that lives as long as the sandbox. Raises SandboxError."""
        if self._closed:
            raise SandboxError("the judging was ended")
        try:
            return Path(tempfile.mkdtemp(dir=self.scratch, prefix=prefix))
        except OSError as error:
            raise SandboxError(f"{self.scratch}: no scratch space: {error.strerror}") from None

    def close(self) -> None:
        """End all runs and keepers, and remove the scratch directory."""
        with self._lock:
            self._closed = True
            keepers = list(self._all)
        for keeper in keepers:
            keeper.hang_up()
        for keeper in keepers:
            keeper.end()
        self._groups.close(self.scratch.name)
        remove(self.scratch)

    def _take(self) -> _Keeper:
        with self._lock:
            if self._closed:
                raise SandboxError("the judging was ended")
            if self._idle:
                return self._idle.pop()
            keeper = _Keeper(self.scratch)
            self._all = [k for k in self._all if k.alive()] + [keeper]
            return keeper

    def _give_back(self, keeper: _Keeper) -> None:
        with self._lock:
            if keeper.alive():
                self._idle.append(keeper)


class _Keeper:
    """One keeper process, and the two pipes to it. Raises SandboxError."""

    def __init__(self, scratch: Path) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-I", "-S", "-c", BOOT, str(ROOT), str(scratch)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env={},
            cwd="/",
            start_new_session=True,  # Ctrl-C is the judge's to handle
        )
        try:
            why = self._reply(ANSWER_MARGIN_S)["error"]
            if why is not None:
                raise SandboxError(f"{scratch.parent}: no scratch space: {why}")
        except BaseException:
            self.end()
            raise

    def alive(self) -> bool:
        return self._process.poll() is None

    def ask(self, request: dict[str, Any], timeout_s: float) -> dict[str, Any]:
        """Send one request and wait for its reply. Raises SandboxError."""
        stdin = self._process.stdin
        assert stdin is not None
        try:
            stdin.write(json.dumps(request).encode() + b"\n")
            stdin.flush()
        except (OSError, ValueError):  # ValueError: closed by hang_up in another thread
            raise SandboxError(LOST) from None
        return self._reply(timeout_s)

    def _reply(self, timeout_s: float) -> dict[str, Any]:
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
            raise SandboxError(LOST)
        reply: dict[str, Any] = json.loads(line)
        return reply

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
            self._process.wait(timeout=15)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        if self._process.stdout is not None:
            self._process.stdout.close()
