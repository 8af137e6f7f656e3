"""One run: from the launch of a program to its facts."""

from __future__ import annotations

import os
import select
import time
from pathlib import Path
from typing import Any

from judge.sandbox.keeper.cgroup import SLACK_MIB
from judge.sandbox.keeper.launch import LaunchError, launch
from judge.sandbox.keeper.pipes import Feeder, Sink
from judge.sandbox.keeper.tree import Tree, peak_mib

CONTROL = 0
SAMPLE_S = 0.02
STARVED_AT_MOST_S = 60.0


class JudgeGoneError(Exception):
    """The judge closed its end: nobody waits for an answer."""


def run(request: dict[str, Any]) -> dict[str, Any]:
    """Run one program to its end and return the facts.

    Request: argv, env, cwd; stdin: path of a file fed through a pipe, or null;
    stdout: path of a file to write; kill_cpu_s, kill_wall_s, memory_mib,
    output_bytes, processes: where to end it; file_mib: the largest file it may write;
    drop: whether to drop from root to an unprivileged user, as a wall always does;
    wall: what `wall.walled` wants, null for none; group: what
    `judge.sandbox.cgroups.Groups.request` returns.
    Reply: the fields of `judge.sandbox.facts.Facts`; stderr as Latin-1 text.
    Raises LaunchError, JudgeGoneError, TimeoutError; no process is left in any case but the last.
    """
    tree = Tree(request["wall"]["scratch"] if request["wall"] else {})
    source_path, out_path = Path(request["stdin"] or os.devnull), Path(request["stdout"])
    with source_path.open("rb") as source, out_path.open("wb") as out:
        started = time.monotonic()
        launched = launch(request)
        pid, tree.clock, tree.group = launched.pid, launched.clock, launched.group
        feeder = Feeder(source.fileno(), launched.stdin)
        sink = Sink(launched.stdout, launched.stderr, out.fileno(), request["output_bytes"])
        try:
            stopped = watch(pid, feeder, sink, tree, started, request)
        finally:
            tree.end()
            launched.clock.close()
            out_of_memory = launched.group.out_of_memory
            launched.group.close()
            feeder.close()
        if stopped is None and out_of_memory:
            stopped = "memory"
            tree.memory_mib = max(tree.memory_mib, request["memory_mib"] + SLACK_MIB)
        wall_s = time.monotonic() - started
        sink.drain()
    stands = os.read(launched.started, 1) if request["wall"] else b"none asked for"
    os.close(launched.started)
    if not stands:
        raise LaunchError(f"the wall does not stand: {sink.stderr.decode('latin-1').strip()}")
    status = tree.status[pid]
    if request["wall"] and stopped is None and os.WIFSIGNALED(status):
        # The program cannot reach what stands around it.
        raise LaunchError(f"the wall was ended by signal {os.WTERMSIG(status)}")
    return {
        "exit_status": os.WEXITSTATUS(status) if os.WIFEXITED(status) else None,
        "signal": os.WTERMSIG(status) if os.WIFSIGNALED(status) else None,
        "cpu_s": tree.cpu_s,
        "wall_s": wall_s,
        "memory_mib": peak_mib(tree),
        "output_bytes": sink.written,
        "stopped": stopped,
        "stderr": sink.stderr.decode("latin-1"),
    }


def watch(
    pid: int, feeder: Feeder, sink: Sink, tree: Tree, started: float, request: dict[str, Any]
) -> str | None:
    """Serve the pipes until the program ends (None) or passes a limit (which one)."""
    pidfd = os.pidfd_open(pid)
    poll = select.poll()
    poll.register(pidfd, select.POLLIN)
    poll.register(CONTROL, select.POLLIN)
    for fd in sink.open_fds:
        poll.register(fd, select.POLLIN)
    poll.register(feeder.fd, select.POLLOUT)
    memory_mib = request["memory_mib"]
    next_sample = started + SAMPLE_S / 4
    try:
        while True:
            wait_s = max(0.0, next_sample - time.monotonic())
            for fd, _ in poll.poll(wait_s * 1000 + 1):
                if fd == CONTROL:
                    raise JudgeGoneError
                if fd == pidfd:
                    return None
                more = feeder.feed() if fd == feeder.fd else sink.take(fd)
                if not more:
                    poll.unregister(fd)
            if sink.written > request["output_bytes"]:
                return "output"
            now = time.monotonic()
            if now < next_sample:
                continue
            next_sample = now + SAMPLE_S
            tree.sample(memory_mib)
            if tree.memory_mib > memory_mib:
                return "memory"
            if tree.processes > request["processes"]:
                return "processes"
            if tree.cpu_s > request["kill_cpu_s"]:
                return "cpu"
            waited_s = now - started - request["kill_wall_s"]
            if waited_s > 0 and waited_s > min(tree.starved_s(), STARVED_AT_MOST_S):
                return "wall"
    finally:
        os.close(pidfd)
