"""Starts a program with its pipes, limits, environment and wall.

Resource limits do not bind root, so a child of root becomes an unprivileged user first. That
user may be unable to reach the program's files (a home directory is closed to others), so
before that, root binds them to other places in a private mount namespace.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import resource
import signal
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from judge.sandbox.keeper.proc import LIBC, threads_of
from judge.sandbox.keeper.protocol import Request, WallRequest

PR_SET_PDEATHSIG = 1
OPEN_FILES = 256
FILE_MIB = 256  # the largest file a run may write into its scratch directory
FIRST_TO_BE_KILLED = "1000"  # where memory runs out, before the keeper
# By Python, and by the keeper.
IGNORED = (signal.SIGPIPE, signal.SIGXFSZ, signal.SIGINT, signal.SIGTERM, signal.SIGHUP)

CLONE_NEWNS = 0x20000
MS_BIND, MS_REC, MS_PRIVATE, MS_NOSUID, MS_NODEV = 0x1000, 0x4000, 0x40000, 2, 4
STAGE = "/sys"  # every system has it, and a private mount covers nothing there that is needed
# The first command tells the keeper that the wall stands. RLIMIT_NPROC counts the processes of a
# user namespace only if it is set inside; dash and bash name it differently. A shell reads no
# more of a pipe than the line that it was told to.
REPORT = 9  # dash knows only descriptors of one digit
INNER = 'echo >&9; exec 9>&-; ulimit -u "$0" 2>/dev/null || ulimit -p "$0"; read -r _; exec "$@"'
GO = b"\n"


class RunError(Exception):
    """The program could not be run, which is not its fault; the message says why."""


class Launched(NamedTuple):
    """A program that was started, and our non-blocking ends of its pipes.

    Behind a wall, it waits for GO on its standard input.
    """

    pid: int
    pipes: tuple[int, int, int]  # standard input, output and error

    @property
    def ended(self) -> bool:
        """Whether it has ended; it still is to be waited for."""
        options = os.WEXITED | os.WNOHANG | os.WNOWAIT
        return os.waitid(os.P_PID, self.pid, options) is not None

    def close(self) -> None:
        """Close the pipes."""
        for fd in self.pipes:
            os.close(fd)


def launch(request: Request) -> Launched:
    """Start the program, and wait until its wall stands.

    Raises RunError; then no open file is left, and no process that goes on.
    """
    stdin, feed = os.pipe()
    take_out, stdout = os.pipe()
    take_err, stderr = os.pipe()
    reports, report = os.pipe()
    pid = os.fork()
    if pid == 0:
        try:
            become(request, (stdin, stdout, stderr), report)
        except BaseException as error:
            os.write(report, f"{request.argv[0]}: {error}".encode())
        finally:
            os._exit(127)
    for fd in (stdin, stdout, stderr, report):
        os.close(fd)
    # Without a wall, exec closes the pipe. Behind one, whatever fails later is the program's fault.
    found = os.read(reports, 4096)
    os.close(reports)
    launched = Launched(pid, (feed, take_out, take_err))
    for fd in launched.pipes:
        os.set_blocking(fd, False)
    if found == (b"\n" if request.wall else b""):
        return launched
    with contextlib.suppress(BlockingIOError):
        found = found or b"the wall cannot be built: " + os.read(take_err, 4096)
    launched.close()
    raise RunError(found.decode("latin-1").strip())


def become(request: Request, standard: tuple[int, int, int], report: int) -> None:
    """In the child: become the program. Never returns. Raises OSError."""
    if not request.wall:  # bubblewrap makes a session of its own
        os.setsid()
    for target, fd in enumerate(standard):
        os.dup2(fd, target)
    for number in IGNORED:
        signal.signal(number, signal.SIG_DFL)  # exec would keep that they are ignored
    limits = request.limits
    processes = 4 * limits.processes
    if request.user is None:  # this limit does not bind root, and counts all that a user runs
        processes += threads_of(os.getuid())
    for what, value in (
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_CPU, int(limits.kill_cpu_s) + 2),  # in case the keeper is stopped
        (resource.RLIMIT_STACK, limits.memory_mib << 20),  # so that deep recursion works
        (resource.RLIMIT_NOFILE, OPEN_FILES),  # each may hold uncounted kernel memory
        (resource.RLIMIT_FSIZE, FILE_MIB << 20),
        (resource.RLIMIT_NPROC, processes),
    ):
        hard = resource.getrlimit(what)[1]
        value = value if hard == resource.RLIM_INFINITY else min(value, hard)
        resource.setrlimit(what, (value, value))
    with contextlib.suppress(OSError):  # where /proc is read-only
        Path("/proc/self/oom_score_adj").write_text(FIRST_TO_BE_KILLED)
    program, argv = request.argv[0], list(request.argv)
    if request.wall:
        os.dup2(report, REPORT)
        program, argv = request.wall.bwrap, walled(request.wall, argv, limits.processes)
        if request.wall.staged:
            stage(request.wall.staged)
    if request.user is not None:
        os.setgroups([])
        os.setresgid(request.user, request.user, request.user)
        os.setresuid(request.user, request.user, request.user)
    os.chdir(request.cwd)
    LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGKILL)  # last: changing the user undoes it
    os.execve(program, argv, request.env)


def walled(wall: WallRequest, argv: Sequence[str], processes: int) -> list[str]:
    """Return the arguments of bubblewrap, with which it inherits open files."""
    seccomp = _inherited(bytes.fromhex(wall.seccomp))
    args = ("--seccomp", str(seccomp), *wall.args)
    # Passed through a descriptor, because the program could read a command line.
    told = _inherited("".join(f"{arg}\0" for arg in args).encode())
    return ["bwrap", "--args", str(told), "--", "/bin/sh", "-c", INNER, str(processes), *argv]


def open_to_all(path: str | Path, below: str | Path = "/") -> bool:
    """Tell whether every user who reaches `below` can reach `path`."""
    parents = [parent for parent in Path(path).parents if parent.is_relative_to(below)]
    return all(parent.stat().st_mode & 0o001 for parent in parents)


def stage(sources: Sequence[str]) -> None:
    """Bind each of `sources` below STAGE, as 0, 1, ..., in a new mount namespace.

    Raises OSError.
    """
    _call("unshare", CLONE_NEWNS)
    _call("mount", b"none", b"/", None, MS_REC | MS_PRIVATE, None)
    _call("mount", b"stage", STAGE.encode(), b"tmpfs", MS_NOSUID | MS_NODEV, None)
    Path(STAGE).chmod(0o755)
    for number, source in enumerate(sources):
        target = Path(STAGE, str(number))
        target.mkdir()
        _call("mount", os.fsencode(source), bytes(target), None, MS_BIND, None)


def _call(name: str, *arguments: bytes | int | None) -> None:
    """Call a function of the C library. Raises OSError."""
    if getattr(LIBC, name)(*arguments):
        error = ctypes.get_errno()
        raise OSError(error, f"{name}: {os.strerror(error)}")


def _inherited(content: bytes) -> int:
    """Return a descriptor that survives exec and reads as `content`."""
    fd = os.memfd_create("wall", 0)
    os.write(fd, content)
    os.lseek(fd, 0, os.SEEK_SET)
    return fd
