"""Runs programs through keepers: one command in, its facts out."""

from __future__ import annotations

import os
import secrets
import tempfile
import threading
from collections.abc import Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from pathlib import Path
from signal import SIGKILL

from judge.sandbox.facts import Facts, RunLimits
from judge.sandbox.keeper.cgroup import Cgroups
from judge.sandbox.keeper.launch import open_to_all
from judge.sandbox.keeper.protocol import Request
from judge.sandbox.keeper.remove import remove
from judge.sandbox.keepers import Keeper, LostKeeperError, SandboxError
from judge.sandbox.wall import PROGRAM, SCRATCH, Wall

__all__ = ["Command", "Sandbox", "SandboxError"]

KILLED = 128 + SIGKILL  # how a wall, or a shell, passes SIGKILL on
VMSTAT = Path("/proc/vmstat")
LEAST_SCRATCH_KIB = 1024  # if less is left, a failed compilation may lack space
UNCOUNTED_MIB = 500  # measured with mappings, pipes and epoll watches; see docs/security.md
ENDED = "the judging was ended"


@dataclass(frozen=True, slots=True)
class Command:
    """A command to run.

    argv[0]: an absolute path, as the program sees it. env: the whole environment except
    HOME and TMPDIR. directory: the program's own, the only one of ours that a wall shows.
    prefixes: directories outside the system that hold the tools of its language.
    """

    argv: tuple[str, ...]
    env: Mapping[str, str] = field(default_factory=dict)
    directory: Path | None = None
    prefixes: tuple[str, ...] = ()


class Sandbox(AbstractContextManager["Sandbox"]):
    """A pool of keepers and a scratch directory, both gone when it is closed.

    Any number of threads may call `run` at once; each run has a keeper to itself. keepers:
    how many to start in advance. They remove the scratch directory if this process dies for any
    reason. Raises SandboxError if it cannot be made.
    """

    def __init__(
        self, wall: Wall | None = None, keepers: int = 1, cgroups: Cgroups | None = None
    ) -> None:
        self.wall = wall
        self._cgroups = cgroups or Cgroups()
        name = f"collision-course-{secrets.token_hex(8)}"
        self.scratch = Path(tempfile.gettempdir()).resolve() / name
        self._lock = threading.Lock()
        self._closed = False
        self._all: list[Keeper] = []
        self._idle: list[Keeper] = []
        try:
            for _ in range(keepers):
                self._idle.append(self._new_keeper())
            # Made when a keeper is there that will remove it. Root's programs run as another
            # user, who must be able to enter but not to list it.
            self.scratch.mkdir(mode=0o700 if os.getuid() else 0o711)
        except BaseException as error:  # even KeyboardInterrupt: the directory may exist
            self.close()
            if isinstance(error, OSError):
                raise self._no_space(error) from None
            raise

    def __exit__(self, *_error: object) -> None:
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
        """Run `command` to its end and return the facts; no process is left.

        stdin: file fed through a pipe, None for an empty one. stdout: file that receives at
        most `limits.output_bytes`. compiling: it may write to `command.directory`.
        It is repeated once, and only if it or its keeper was killed while the kernel ran out of
        memory. How a program ended is no evidence: one that fails at random could buy itself
        another try. Raises SandboxError.
        """
        kills = out_of_memory_kills()
        try:
            facts = self._run(command, limits, stdin, stdout, compiling)
            again = killed_by_another(facts) and out_of_memory_kills() > kills
        except LostKeeperError:
            again = not self._closed and out_of_memory_kills() > kills
            if not again:
                raise
        if again:
            facts = self._run(command, limits, stdin, stdout, compiling)
        if compiling and killed_by_another(facts):
            raise SandboxError("something killed the compiler")
        return facts

    def _run(
        self, command: Command, limits: RunLimits, stdin: Path | None, stdout: Path, compiling: bool
    ) -> Facts:
        home = SCRATCH if self.wall else self.new_directory("run-")
        keeper = self._take()
        try:
            wall = user = None
            if self.wall:
                counted = bool(self._cgroups.places)
                wall = self.wall.request(command.directory, compiling, command.prefixes, counted)
            if os.getuid() == 0 and (wall or self._open_to_all(command)):
                user = keeper.user
                if not wall:
                    os.chown(home, user, user)
                if compiling and command.directory:
                    os.chown(command.directory, user, user)
            request = Request(
                argv=command.argv,
                env={**command.env, "HOME": str(home), "TMPDIR": str(home)},
                cwd="/" if wall else str(home),
                user=user,
                wall=wall,
                stdin=None if stdin is None else str(stdin),
                stdout=str(stdout),
                limits=limits,
            )
            facts = keeper.ask(request)
        except BaseException:
            keeper.end()
            raise
        finally:
            if not self.wall:
                remove(home)
        if facts.all_ended:
            with self._lock:
                self._idle.append(keeper)
        return facts

    @property
    def protection(self) -> str | None:
        """What is around every run, in words; None without a wall."""
        if self.wall is None:
            return None
        if self._cgroups.places:
            return f"{self.wall} and control groups"
        hidden = f"up to {UNCOUNTED_MIB} MiB of kernel memory are not counted"
        return f"{self.wall}, without control groups ({hidden})"

    def inside(self, directory: Path) -> Path:
        """Return the path at which a program sees its `directory`."""
        return PROGRAM if self.wall else directory

    def new_program_directory(self) -> Path:
        """Return an empty directory that a compiler behind the wall may write to."""
        directory = self.new_directory("program-")
        directory.chmod(0o755)
        return directory

    def new_directory(self, prefix: str) -> Path:
        """Return an empty directory that exists until `close`. Raises SandboxError."""
        if self._closed:
            raise SandboxError(ENDED)
        try:
            return Path(tempfile.mkdtemp(dir=self.scratch, prefix=prefix))
        except OSError as error:
            raise self._no_space(error) from None

    def check_space(self) -> None:
        """Raise SandboxError if less than LEAST_SCRATCH_KIB is left for scratch files."""
        seen = os.statvfs(self.scratch)
        left_kib = seen.f_bavail * seen.f_frsize >> 10
        if left_kib < LEAST_SCRATCH_KIB:
            raise SandboxError(
                f"{self.scratch.parent}: no scratch space: expected {LEAST_SCRATCH_KIB} KiB, "
                f"found {left_kib} KiB"
            )

    def close(self) -> None:
        """Stop all runs and keepers and remove the scratch directory; may be called twice."""
        with self._lock:
            self._closed = True
        for keeper in self._all:
            keeper.hang_up()
        for keeper in self._all:
            keeper.end()
        self._cgroups.close(self.scratch.name)
        remove(self.scratch)

    def _no_space(self, error: OSError) -> SandboxError:
        return SandboxError(f"{self.scratch.parent}: no scratch space: {error.strerror}")

    def _open_to_all(self, command: Command) -> bool:
        """Tell whether every user can reach the files that the command needs."""
        needed = (os.path.realpath(command.argv[0]), *command.prefixes, f"{self.scratch}/run")
        try:
            return all(map(open_to_all, needed))
        except OSError:  # a file is missing: the launch will report it
            return False

    def _take(self) -> Keeper:
        with self._lock:
            if self._closed:
                raise SandboxError(ENDED)
            while self._idle:
                keeper = self._idle.pop()
                if keeper.alive():
                    return keeper
            return self._new_keeper()

    def _new_keeper(self) -> Keeper:
        keeper = Keeper(self.scratch, self._cgroups)
        self._all = [each for each in self._all if each.alive()] + [keeper]
        return keeper


def killed_by_another(facts: Facts) -> bool:
    """Tell whether a SIGKILL that the keeper did not send ended the run."""
    return facts.stopped is None and (facts.signal == SIGKILL or facts.exit_status == KILLED)


def out_of_memory_kills(vmstat: Path = VMSTAT) -> int:
    """Return how many processes the kernel has killed for want of memory, 0 if it is unknown."""
    lines = vmstat.read_text().splitlines() if vmstat.exists() else []
    return next((int(line.split()[1]) for line in lines if line.startswith("oom_kill ")), 0)
