"""Reads what /proc says about the processes below this one."""

from __future__ import annotations

import contextlib
import ctypes
import os
from pathlib import Path
from typing import NamedTuple

LIBC = ctypes.CDLL(None, use_errno=True)  # for calls that Python does not offer
TICK_S = 1 / os.sysconf("SC_CLK_TCK")
PAGE_MIB = os.sysconf("SC_PAGE_SIZE") / 2**20

# Indices into `fields`; the states of ended processes, and a flag. Source: proc(5).
STATE, FLAGS, USER, SYSTEM, WAITED_USER, WAITED_SYSTEM = 0, 6, 11, 12, 13, 14
THREADS, STARTED, RESIDENT = 17, 19, 21
ENDED, EXITING = "ZX", 0x4


def descendants() -> list[int]:
    """Return the pids of all processes below the keeper, parents first."""
    found, unseen = [], children(os.getpid())
    while unseen:
        pid = unseen.pop()
        found.append(pid)
        unseen += children(pid)
    return found


def children(pid: int) -> list[int]:
    """Return the children of a process; none if it is gone."""
    return [int(child) for task in tasks(pid) for child in read(f"{task}/children").split()]


def tasks(pid: int) -> list[str]:
    """Return the directories of the threads of a process; none if it is gone."""
    try:
        return [task.path for task in os.scandir(f"/proc/{pid}/task")]
    except OSError:
        return []


def threads_of(user: int) -> int:
    """Return how many threads a user has, which is what RLIMIT_NPROC counts."""
    count = 0
    for process in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            if process.stat().st_uid == user:
                count += len(tasks(int(process.name)))
    return count


class Process(NamedTuple):
    """One sample of a live process.

    place: its directory in /proc; if its first thread has ended, which then shows no memory,
    that of another thread. own_s, waited_s: CPU seconds, its own and those of the children
    that it reaped.
    """

    pid: int
    started: str
    place: str
    own_s: float
    waited_s: float
    resident_mib: float

    @property
    def identity(self) -> tuple[int, str]:
        """A unique identity: pids are reused, but not with the same start time."""
        return self.pid, self.started


def look_at(pid: int) -> Process | None:
    """Return a sample of a process, None if it is gone."""
    place = f"/proc/{pid}"
    stat = memory = fields(place)
    if not stat:
        return None
    if stat[STATE] == "Z" and int(stat[THREADS]) > 1:
        for task in tasks(pid):
            of_task = fields(task)
            if of_task and of_task[STATE] not in ENDED:
                place, memory = task, of_task
    return Process(
        pid,
        stat[STARTED],
        place,
        (int(stat[USER]) + int(stat[SYSTEM])) * TICK_S,
        (int(stat[WAITED_USER]) + int(stat[WAITED_SYSTEM])) * TICK_S,
        int(memory[RESIDENT]) * PAGE_MIB,
    )


def fields(place: str) -> list[str]:
    """Return the fields of a `stat` from the state on; none if the process is gone."""
    return read(f"{place}/stat").rpartition(")")[2].split()


def read(path: str | Path) -> str:
    """Return the text of a file of /proc or a control group; empty if its process is gone."""
    try:
        with Path(path).open("rb", buffering=0) as file:
            return file.read().decode("latin-1")
    except OSError:
        return ""
