"""One run: from the launch of a program to its facts."""

from __future__ import annotations

import os
import select
import time
from pathlib import Path

from judge.sandbox.facts import STARVED_AT_MOST_S, UNLISTED_PROCESSES, Facts, RunLimits, Stop
from judge.sandbox.keeper.cgroup import SLACK_MIB, Cgroup
from judge.sandbox.keeper.launch import GO, Launched, RunError, launch
from judge.sandbox.keeper.pipes import Pipes
from judge.sandbox.keeper.protocol import Request
from judge.sandbox.keeper.tree import Tree

CONTROL = 0
FIRST_SAMPLE_S, SAMPLE_S = 0.005, 0.02  # early samples, for short runs
SAMPLE_GROWTH = 0.4
WALL_PROCESSES = 3  # bubblewrap, the first process inside, the shell that starts the program
SAMPLES_SHARE = 0.25  # of the time goes into samples, however many processes there are


class JudgeGoneError(Exception):
    """The judge closed its end: nobody waits for an answer."""


def run(request: Request, ahead: Launched | None, cgroup: Cgroup) -> Facts:
    """Run one program to its end and return the facts.

    ahead: the program, if it was launched already and waits. Raises RunError, JudgeGoneError.
    After the first, or if not `all_ended`, processes may be left that are still dying.
    """
    limits = request.limits
    tree = Tree(request.wall.scratch if request.wall else {}, cgroup)
    cgroup.begin(limits.memory_mib, limits.processes + WALL_PROCESSES)
    source_path, out_path = Path(request.stdin or os.devnull), Path(request.stdout)
    with source_path.open("rb") as source, out_path.open("wb") as out:
        launched = ahead or launch(request)
        started = time.monotonic()
        head = GO if request.wall else b""
        pipes = Pipes(*launched.pipes, head, source.fileno(), out.fileno(), limits.output_bytes)
        try:
            stopped = watch(launched.pid, pipes, tree, started, limits, cgroup)
        finally:
            if cgroup.there:  # what its children hold at the end counts
                tree.sample(limits.memory_mib)
            all_ended = tree.end()
        if stopped in (None, Stop.MEMORY) and cgroup.out_of_memory:
            stopped = Stop.MEMORY
            tree.memory_mib = max(tree.memory_mib, limits.memory_mib + SLACK_MIB)
        elapsed_s = time.monotonic() - started
        pipes.drain()
    if launched.pid not in tree.status:
        raise RunError("the program cannot be killed")
    status = tree.status[launched.pid]
    if stopped is None and request.wall and os.WIFSIGNALED(status):
        # This is bubblewrap's own process, which the program cannot reach.
        raise RunError(f"the wall was ended by signal {os.WTERMSIG(status)}")
    return Facts(
        exit_status=os.WEXITSTATUS(status) if os.WIFEXITED(status) else None,
        signal=os.WTERMSIG(status) if os.WIFSIGNALED(status) else None,
        cpu_s=tree.cpu_s,
        elapsed_s=elapsed_s,
        memory_mib=tree.peak_mib(),
        output_bytes=pipes.written,
        stopped=stopped,
        stderr=pipes.stderr,
        all_ended=all_ended,
    )


def watch(
    pid: int, pipes: Pipes, tree: Tree, started: float, limits: RunLimits, cgroup: Cgroup
) -> Stop | None:
    """Serve the pipes until the program ends (return None) or passes a limit (return which)."""
    pidfd = os.pidfd_open(pid)
    poll = select.poll()
    for fd in (pidfd, CONTROL, *pipes.open_fds):
        poll.register(fd, select.POLLIN | select.POLLOUT)
    most_processes = limits.processes if cgroup.there else min(limits.processes, UNLISTED_PROCESSES)
    next_sample = started + FIRST_SAMPLE_S
    try:
        while True:
            wait_s = max(0.0, next_sample - time.monotonic())
            for fd, _ in poll.poll(wait_s * 1000 + 1):
                if fd == CONTROL:
                    raise JudgeGoneError
                if fd == pidfd:
                    return None
                if not pipes.serve(fd):
                    poll.unregister(fd)
            if pipes.written > limits.output_bytes:
                return Stop.OUTPUT
            now = time.monotonic()
            if now < next_sample:
                continue
            growing_s = max(FIRST_SAMPLE_S, SAMPLE_GROWTH * (now - started))
            tree.sample(limits.memory_mib)
            slow_s = (time.monotonic() - now) / SAMPLES_SHARE
            next_sample = now + max(slow_s, min(growing_s, SAMPLE_S))
            if tree.memory_mib > limits.memory_mib or cgroup.out_of_memory:
                return Stop.MEMORY
            if tree.processes > most_processes:
                return Stop.PROCESSES
            if tree.cpu_s > limits.kill_cpu_s:
                return Stop.CPU
            waited_s = now - started - limits.kill_elapsed_s
            if waited_s > 0 and waited_s > min(tree.starved_s(), STARVED_AT_MOST_S):
                return Stop.ELAPSED
    finally:
        os.close(pidfd)
