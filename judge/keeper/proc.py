"""What /proc says of the processes below this one."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

TICK_S = 1 / os.sysconf("SC_CLK_TCK")
PAGE_MIB = os.sysconf("SC_PAGE_SIZE") / 2**20
INODE_BYTES = 1024  # of a memory file system, its name included; about
SOCKET_MIB = 0.4  # what one may hold that was not read: twice net.core.wmem_max, as most have it
TABLES_MATTER_MIB = 4096.0  # of addresses; whoever has fewer has at most 8 MiB of tables

# Where `fields` has what, and two of the states and flags. Source: proc(5).
STATE, FLAGS, USER, SYSTEM, WAITED_USER, WAITED_SYSTEM = 0, 6, 11, 12, 13, 14
THREADS, STARTED, MAPPED, RESIDENT = 17, 19, 20, 21
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
    return [int(c) for t in tasks(pid) for c in read(f"/proc/{pid}/task/{t}/children").split()]


def tasks(pid: int) -> list[str]:
    """Return the threads of a process; none if it is gone."""
    try:
        return [task.name for task in Path(f"/proc/{pid}/task").iterdir()]
    except OSError:
        return []


def threads_of(user: int) -> int:
    """Return how many threads a user has: RLIMIT_NPROC counts them all."""
    count = 0
    for process in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            if process.stat().st_uid == user:
                count += len(tasks(int(process.name)))
    return count


class Process(NamedTuple):
    """What one look at a live process showed.

    pid, started: what names it. place: its directory in /proc, or that of a thread of
    it: a first thread that has ended shows none of the memory that the others hold.
    own_s, waited_s: CPU seconds, its own and of children it waited for. mapped_mib:
    addresses, used or not.
    """

    pid: int
    started: str
    place: str
    own_s: float
    waited_s: float
    resident_mib: float
    mapped_mib: float


def look_at(pid: int) -> Process | None:
    """Return what a process shows, None if it is gone."""
    place = f"/proc/{pid}"
    stat = fields(place)
    if not stat:
        return None
    memory = stat
    if stat[STATE] == "Z" and int(stat[THREADS]) > 1:
        threads = ((f"{place}/task/{name}", fields(f"{place}/task/{name}")) for name in tasks(pid))
        living = [(p, f) for p, f in threads if f and f[STATE] not in ENDED]
        place, memory = living[-1] if living else (place, stat)
    return Process(
        pid,
        stat[STARTED],
        place,
        (int(stat[USER]) + int(stat[SYSTEM])) * TICK_S,
        (int(stat[WAITED_USER]) + int(stat[WAITED_SYSTEM])) * TICK_S,
        int(memory[RESIDENT]) * PAGE_MIB,
        int(memory[MAPPED]) / 2**20,
    )


def fields(place: str) -> list[str]:
    """Return the fields of a `stat` from the state on; none if the process is gone."""
    return read(f"{place}/stat").rpartition(")")[2].split()


def proportional_mib(process: Process) -> float:
    """Return the memory of a process with every shared page divided among its users.

    A process may keep others from looking: then it is what is resident, unless it is
    ending and has nothing any more.
    """
    for line in read(f"{process.place}/smaps_rollup").splitlines():
        if line.startswith("Pss:"):
            return int(line.split()[1]) / 1024
    stat = fields(process.place)
    return 0.0 if not stat or int(stat[FLAGS]) & EXITING else process.resident_mib


def tables_mib(process: Process) -> float:
    """Return the memory that only says where memory is: it may be more than the memory."""
    if process.mapped_mib < TABLES_MATTER_MIB:
        return 0.0
    for line in read(f"{process.place}/status").splitlines():
        if line.startswith("VmPTE:"):
            return int(line.split()[1]) / 1024
    return 0.0


def held_mib(process: Process, scratch: Mapping[str, int]) -> float:
    """Return what file systems and sockets behind a wall hold, as `process` sees them.

    scratch: the sizes in bytes of the file systems by place; none without a wall. One of
    another size is not ours: the wall is not built to its end yet, and the process still
    sees this machine's own.
    """
    if not scratch:
        return 0.0
    held = 0
    for place, size in scratch.items():
        try:
            seen = os.statvfs(f"{process.place}/root{place}")
        except OSError:
            return 0.0
        if seen.f_blocks * seen.f_frsize != size:
            return 0.0
        held += (seen.f_blocks - seen.f_bfree) * seen.f_frsize
        held += (seen.f_files - seen.f_ffree) * INODE_BYTES
    sockets = read(f"{process.place}/net/sockstat").split()  # ["sockets:", "used", "8", ...
    return held / 2**20 + (int(sockets[2]) * SOCKET_MIB if sockets else 0.0)


def read(path: str) -> str:
    """Return the text of a file of /proc; empty if the process is gone."""
    try:
        with Path(path).open("rb", buffering=0) as file:
            return file.read().decode("latin-1")
    except OSError:
        return ""
