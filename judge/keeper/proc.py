"""What /proc says of the processes below this one."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Mapping
from pathlib import Path

INODE_BYTES = 1024  # of a memory file system, its name included; about


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
    try:
        threads = list(Path(f"/proc/{pid}/task").iterdir())
    except OSError:
        return []
    return [int(c) for t in threads for c in read(f"{t}/children").split()]


def threads_of(user: int) -> int:
    """Return how many threads a user has: RLIMIT_NPROC counts them all."""
    count = 0
    for process in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            if process.stat().st_uid == user:
                count += len(list((process / "task").iterdir()))
    return count


def proportional_mib(pid: int, otherwise_mib: float) -> float:
    """Return the memory of a process with every shared page divided among its users.

    A process may keep others from looking: then it is `otherwise_mib`.
    """
    for line in read(f"/proc/{pid}/smaps_rollup").splitlines():
        if line.startswith("Pss:"):
            return int(line.split()[1]) / 1024
    return otherwise_mib


def held_mib(pid: int, scratch: Mapping[str, int]) -> float:
    """Return the memory that file systems hold, as `pid` sees them.

    scratch: their sizes in bytes by place. One of another size is not ours: the wall is
    not built to its end yet, and the process still sees this machine's own.
    """
    held = 0
    for place, size in scratch.items():
        try:
            seen = os.statvfs(f"/proc/{pid}/root{place}")
        except OSError:
            continue
        if seen.f_blocks * seen.f_frsize == size:
            held += (seen.f_blocks - seen.f_bfree) * seen.f_frsize
            held += (seen.f_files - seen.f_ffree) * INODE_BYTES
    return held / 2**20


def read(path: str) -> str:
    """Return the text of a file of /proc; empty if the process is gone."""
    try:
        with Path(path).open("rb", buffering=0) as file:
            return file.read().decode("latin-1")
    except OSError:
        return ""
