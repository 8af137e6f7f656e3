"""Starts a program with its pipes, limits and environment."""

from __future__ import annotations

import contextlib
import os
import resource
import signal
from pathlib import Path
from typing import NamedTuple

from judge.sandbox.keeper.proc import LIBC, threads_of
from judge.sandbox.keeper.protocol import Request
from judge.sandbox.keeper.wall import STARTED, become_user, walled

PR_SET_PDEATHSIG = 1
OPEN_FILES = 256
FIRST_TO_BE_KILLED = "1000"  # where memory runs out, before the keeper
# By Python, and by the keeper.
IGNORED = (signal.SIGPIPE, signal.SIGXFSZ, signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class RunError(Exception):
    """The program could not be run, which is not its fault; the message says why."""


class Launched(NamedTuple):
    """A program that was started, and our non-blocking ends of its pipes.

    Behind a wall, it waits for GO on its standard input. wall_stands: a pipe that stays empty if
    bubblewrap failed to start.
    """

    pid: int
    stdin: int
    stdout: int
    stderr: int
    wall_stands: int

    @property
    def ended(self) -> bool:
        """Whether it has ended; it still is to be waited for."""
        options = os.WEXITED | os.WNOHANG | os.WNOWAIT
        return os.waitid(os.P_PID, self.pid, options) is not None

    def close(self) -> None:
        """Close the pipes."""
        for fd in self[1:]:
            os.close(fd)


def launch(request: Request) -> Launched:
    """Start the program. Raises RunError; then no process or open file is left."""
    stdin, feed = os.pipe()
    take_out, stdout = os.pipe()
    take_err, stderr = os.pipe()
    wall_stands, wall_starting = os.pipe()
    complaint, complain = os.pipe()
    pid = os.fork()
    if pid == 0:
        try:
            become(request, (stdin, stdout, stderr), wall_starting)
        except BaseException as error:
            os.write(complain, str(error).encode())
        finally:
            os._exit(127)
    for fd in (stdin, stdout, stderr, wall_starting, complain):
        os.close(fd)
    launched = Launched(pid, feed, take_out, take_err, wall_stands)
    problem = os.read(complaint, 4096)  # exec closes the other end, so this returns at once
    os.close(complaint)
    if problem:
        os.waitpid(pid, 0)
        launched.close()
        raise RunError(f"{request.argv[0]}: {problem.decode()}")
    for fd in launched[1:]:
        os.set_blocking(fd, False)
    return launched


def become(request: Request, standard: tuple[int, int, int], wall_starting: int) -> None:
    """In the child: become the program. Never returns. Raises OSError."""
    if not request.wall:  # bubblewrap makes a session of its own
        os.setsid()
    for target, fd in enumerate(standard):
        os.dup2(fd, target)
    for number in IGNORED:
        signal.signal(number, signal.SIG_DFL)  # exec would keep that they are ignored
    processes = 4 * request.processes
    if request.user is None:  # this limit does not bind root, and counts all that a user runs
        processes += threads_of(os.getuid())
    for what, value in (
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_CPU, int(request.kill_cpu_s) + 2),  # in case the keeper is stopped
        (resource.RLIMIT_STACK, request.memory_mib << 20),  # so that deep recursion works
        (resource.RLIMIT_NOFILE, OPEN_FILES),  # each may hold uncounted kernel memory
        (resource.RLIMIT_FSIZE, request.file_mib << 20),
        (resource.RLIMIT_NPROC, processes),
    ):
        hard = resource.getrlimit(what)[1]
        value = value if hard == resource.RLIM_INFINITY else min(value, hard)
        resource.setrlimit(what, (value, value))
    with contextlib.suppress(OSError):  # where /proc is read-only
        Path("/proc/self/oom_score_adj").write_text(FIRST_TO_BE_KILLED)
    program, argv = request.argv[0], list(request.argv)
    if request.wall:
        os.dup2(wall_starting, STARTED)
        program, argv = walled(request.wall, argv, request.processes, request.user)
    elif request.user is not None:
        become_user(request.user)
    os.chdir(request.cwd)
    LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGKILL)  # last: changing the user undoes it
    os.execve(program, argv, request.env)
