"""Starts a program with its pipes, limits and environment."""

from __future__ import annotations

import os
import resource
import signal
from typing import Any, NamedTuple

from judge.sandbox.keeper.cgroup import Group
from judge.sandbox.keeper.clock import Clock
from judge.sandbox.keeper.libc import LIBC
from judge.sandbox.keeper.proc import threads_of
from judge.sandbox.keeper.wall import NOBODY, STARTED, drop, walled

PR_SET_PDEATHSIG = 1
SHARED_PROCESSES = 4096
OPEN_FILES = 512


class LaunchError(Exception):
    """The program could not be started; the message says why."""


class Launched(NamedTuple):
    """A started program, what counts its time, and our non-blocking ends of its pipes.

    started: one pipe more, which reads as nothing if there was to be a wall and it did not stand.
    """

    pid: int
    clock: Clock
    group: Group
    stdin: int
    stdout: int
    stderr: int
    started: int


def launch(request: dict[str, Any]) -> Launched:
    """Start the program. Raises LaunchError, after which nothing of it is left."""
    stdin, feed = os.pipe()
    take_out, stdout = os.pipe()
    take_err, stderr = os.pipe()
    started, starting = os.pipe()
    complaint, complain = os.pipe()
    gate, opened = os.pipe()
    pid = os.fork()
    if pid == 0:
        try:
            os.close(opened)
            become(request, (stdin, stdout, stderr), starting, gate)
        except BaseException as error:
            os.write(complain, str(error).encode())
        finally:
            os._exit(127)
    clock = Clock(pid)
    directory = place_of_group(request, clock)
    group = Group(directory, pid, request["memory_mib"], 4 * request["processes"])
    for fd in (stdin, stdout, stderr, starting, complain, gate, opened):
        os.close(fd)
    problem = os.read(complaint, 4096)  # ends at once when the program is executed
    os.close(complaint)
    if problem:
        os.waitpid(pid, 0)
        clock.close()
        group.close()
        for fd in (feed, take_out, take_err, started):
            os.close(fd)
        raise LaunchError(f"{request['argv'][0]}: {problem.decode()}")
    for fd in (feed, take_out, take_err, started):
        os.set_blocking(fd, False)
    return Launched(pid, clock, group, feed, take_out, take_err, started)


def place_of_group(request: dict[str, Any], clock: Clock) -> str | None:
    """Return where to make a control group, None if there is no place or nothing to gain.

    To move a process into a group holds all others up for a moment. Where the clock
    counts all, a wall ends all, and no controller holds anything, a group adds nothing.
    """
    group = request["group"]
    if group is None or (clock.granted and request["wall"] and not group["limits"]):
        return None
    return f"{group['place']}-{os.getpid()}"


def become(
    request: dict[str, Any], standard: tuple[int, int, int], starting: int, gate: int
) -> None:
    """In the child: turn into the program. Never returns; raises OSError."""
    if not request["wall"]:  # bwrap makes a session of its own, further in
        os.setsid()
    for target, fd in enumerate(standard):
        os.dup2(fd, target)
    for number in (signal.SIGPIPE, signal.SIGXFSZ, signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_DFL)  # Python ignores some, and exec would keep that
    if request["wall"] and os.getuid() == 0:
        # The user that a wall drops to shares this limit with all other walls: what holds
        # a walled program is set inside.
        processes = SHARED_PROCESSES
    else:  # root itself is not held by it
        user = NOBODY if request["drop"] else os.getuid()
        processes = 4 * request["processes"] + threads_of(user)
    for what, value in (
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_CPU, int(request["kill_cpu_s"]) + 2),  # should the keeper be stopped
        (resource.RLIMIT_STACK, request["memory_mib"] << 20),  # deep recursion is no crime
        (resource.RLIMIT_NOFILE, OPEN_FILES),  # a descriptor holds memory that nobody counts
        (resource.RLIMIT_FSIZE, request["file_mib"] << 20),
        (resource.RLIMIT_NPROC, processes),
    ):
        hard = resource.getrlimit(what)[1]
        value = value if hard == resource.RLIM_INFINITY else min(value, hard)
        resource.setrlimit(what, (value, value))
    program: str = request["argv"][0]
    argv = request["argv"]
    if request["wall"]:
        os.dup2(starting, STARTED)
        program, argv = walled(request["wall"], argv, request["processes"])
    elif request["drop"]:
        drop()
    os.chdir(request["cwd"])
    LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGKILL)  # last: a change of user would undo it
    os.read(gate, 1)  # until its clock runs: nothing that it starts may be missed
    os.execve(program, argv, request["env"])
