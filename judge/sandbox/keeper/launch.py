"""Starts a program with its pipes, limits and environment."""

from __future__ import annotations

import os
import resource
import signal
from typing import NamedTuple

from judge.sandbox.keeper.cgroup import Cgroup
from judge.sandbox.keeper.clock import Clock
from judge.sandbox.keeper.libc import LIBC
from judge.sandbox.keeper.proc import threads_of
from judge.sandbox.keeper.protocol import Request
from judge.sandbox.keeper.wall import NOBODY, STARTED, drop, walled

PR_SET_PDEATHSIG = 1
SHARED_PROCESSES = 4096
OPEN_FILES = 512
# By Python, and by the keeper.
IGNORED = (signal.SIGPIPE, signal.SIGXFSZ, signal.SIGINT, signal.SIGTERM, signal.SIGHUP)


class LaunchError(Exception):
    """The program could not be started; the message says why."""


class Launched(NamedTuple):
    """A started program, the counters of its time, and our non-blocking ends of its pipes.

    wall_stands: a pipe that stays empty if bubblewrap failed to start.
    """

    pid: int
    clock: Clock
    cgroup: Cgroup
    stdin: int
    stdout: int
    stderr: int
    wall_stands: int


def launch(request: Request) -> Launched:
    """Start the program. Raises LaunchError; then no process or open file is left."""
    stdin, feed = os.pipe()
    take_out, stdout = os.pipe()
    take_err, stderr = os.pipe()
    wall_stands, wall_starting = os.pipe()
    complaint, complain = os.pipe()
    gate, opened = os.pipe()
    pid = os.fork()
    if pid == 0:
        try:
            os.close(opened)
            become(request, (stdin, stdout, stderr), wall_starting, gate)
        except BaseException as error:
            os.write(complain, str(error).encode())
        finally:
            os._exit(127)
    clock = Clock(pid)
    directory = place_of_cgroup(request, clock)
    cgroup = Cgroup(directory, pid, request.memory_mib, 4 * request.processes)
    for fd in (stdin, stdout, stderr, wall_starting, complain, gate, opened):
        os.close(fd)
    problem = os.read(complaint, 4096)  # exec closes the other end, so this returns at once
    os.close(complaint)
    if problem:
        os.waitpid(pid, 0)
        clock.close()
        cgroup.close()
        for fd in (feed, take_out, take_err, wall_stands):
            os.close(fd)
        raise LaunchError(f"{request.argv[0]}: {problem.decode()}")
    for fd in (feed, take_out, take_err, wall_stands):
        os.set_blocking(fd, False)
    return Launched(pid, clock, cgroup, feed, take_out, take_err, wall_stands)


def place_of_cgroup(request: Request, clock: Clock) -> str | None:
    """Return where to make a control group, None if there is no place or nothing to gain.

    Moving a process into a control group stops the whole machine for a moment. Nothing is
    gained if the clock counts every process, a wall ends every process, and no controller
    limits anything.
    """
    cgroup = request.cgroup
    if cgroup is None or (clock.granted and request.wall and not cgroup.limits):
        return None
    return f"{cgroup.place}-{os.getpid()}"


def become(request: Request, standard: tuple[int, int, int], wall_starting: int, gate: int) -> None:
    """In the child: become the program. Never returns. Raises OSError."""
    if not request.wall:  # bubblewrap makes a session of its own
        os.setsid()
    for target, fd in enumerate(standard):
        os.dup2(fd, target)
    for number in IGNORED:
        signal.signal(number, signal.SIG_DFL)  # exec would keep that they are ignored
    if request.wall and os.getuid() == 0:
        # Root's programs all run as one user and share this limit, so it is high. The limit
        # of each program is set inside its wall.
        processes = SHARED_PROCESSES
    else:  # this limit does not bind root
        user = NOBODY if request.drop else os.getuid()
        processes = 4 * request.processes + threads_of(user)
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
    program, argv = request.argv[0], list(request.argv)
    if request.wall:
        os.dup2(wall_starting, STARTED)
        program, argv = walled(request.wall, argv, request.processes)
    elif request.drop:
        drop()
    os.chdir(request.cwd)
    LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGKILL)  # last: changing the user undoes it
    os.read(gate, 1)  # wait until the clock runs, so that it misses nothing
    os.execve(program, argv, request.env)
