"""How much memory the processes of a program use together, shared memory counted once."""

from __future__ import annotations

import os
import time
from collections.abc import Mapping, Sequence

from judge.sandbox.keeper.libc import system_call
from judge.sandbox.keeper.proc import EXITING, FLAGS, Process, fields, read

INODE_BYTES = 1024  # about what a file in a memory file system takes, with its name
WMEM_DEFAULT_BYTES = 212992  # the default of most kernels
FEW = 8  # with so few processes, page tables are read at every sample
WALL_PROCESSES = 2  # bubblewrap itself, and the first process inside
WALL_MIB = 8.0  # each uses less, unless the program has taken it over
SHARED_EVERY_S, SHARED_AT_LEAST_EVERY_S = 0.2, 0.5
SLOWNESS = 10.0  # the pause after an exact measurement is this many times as long
KCMP, KCMP_VM = {"x86_64": 312, "aarch64": 272}, 1


class Memory:
    """Measures the memory of one program at every sample.

    scratch: the wall's memory file systems by place, with their sizes in bytes; empty
    without a wall. Their content counts as the program's memory; no process shows it.
    """

    def __init__(self, scratch: Mapping[str, int]) -> None:
        self._scratch = scratch
        self._shared_mib: dict[tuple[int, str], float] = {}  # at the last exact measurement
        self._next_s = 0.0

    def used_mib(self, live: Sequence[Process], limit_mib: float) -> float:
        """Return the memory in use by all of `live`, parents first.

        Measuring shared memory is slow, so it is done now and then, and whenever the limit
        might be passed; in between, the result is a lower bound.
        """
        walls = live[: WALL_PROCESSES if self._scratch else 0]
        own = [process for process in walls if process.resident_mib > WALL_MIB]
        own = [*own, *live[len(walls) :]] or list(live)
        now_s = time.monotonic()
        is_time = (len(own) > 1 or bool(self._shared_mib)) and now_s >= self._next_s
        beyond_mib = self._held_mib(live)
        if len(own) <= FEW or is_time:
            beyond_mib += sum(map(tables_mib, own))
        likely_mib = [p.resident_mib - self._shared_mib.get(p.identity, 0.0) for p in own]
        if sum(likely_mib) + beyond_mib <= limit_mib and not is_time:
            return max(likely_mib, default=0.0) + beyond_mib
        # Mapped files in scratch are already counted with scratch.
        exact_mib = {p.identity: proportional_mib(p, bool(self._scratch)) for p in distinct(own)}
        self._shared_mib = {
            p.identity: p.resident_mib - exact_mib.get(p.identity, 0.0) for p in own
        }
        slow_s = SLOWNESS * (time.monotonic() - now_s)
        self._next_s = now_s + min(max(slow_s, SHARED_EVERY_S), SHARED_AT_LEAST_EVERY_S)
        return sum(exact_mib.values()) + beyond_mib

    def _held_mib(self, live: Sequence[Process]) -> float:
        """Return what file systems and sockets behind the wall hold, as a process there sees them.

        If a file system has another size, it is this machine's own: the wall is not complete yet.
        """
        if not self._scratch:
            return 0.0
        held = (self._held_bytes(process) for process in live)
        return next((found for found in held if found is not None), 0) / 2**20

    def _held_bytes(self, process: Process) -> int | None:
        """Return what `process` sees of that, None if it does not see all of scratch."""
        held = 0
        for place, size in self._scratch.items():
            try:
                seen = os.statvfs(f"{process.place}/root{place}")
            except OSError:
                return None
            if seen.f_blocks * seen.f_frsize != size:
                return None
            held += (seen.f_blocks - seen.f_bfree) * seen.f_frsize
            held += (seen.f_files - seen.f_ffree) * INODE_BYTES
        sockets = read(f"{process.place}/net/sockstat").split()  # sockets: used 8 ...
        many = int(sockets[2]) if sockets else 0
        return held + (many * _socket_bytes() if many else 0)


def proportional_mib(process: Process, without_scratch: bool) -> float:
    """Return the memory of a process with every shared page divided among its users.

    without_scratch: leave out mapped files of memory file systems. If the process cannot be
    inspected, this is its resident memory, or 0 if it is just ending.
    """
    lines = read(f"{process.place}/smaps_rollup").splitlines()
    kib = {line.split()[0]: int(line.split()[1]) for line in lines if line.endswith(" kB")}
    if "Pss:" in kib:
        return (kib["Pss:"] - (kib.get("Pss_Shmem:", 0) if without_scratch else 0)) / 1024
    stat = fields(process.place)
    return 0.0 if not stat or int(stat[FLAGS]) & EXITING else process.resident_mib


def distinct(processes: Sequence[Process]) -> list[Process]:
    """Leave out processes that run in the memory of another, as between vfork and exec."""
    kept: list[Process] = []
    for process in processes:
        alike = (other for other in kept if other.mapped_mib == process.mapped_mib)
        if not any(_same_memory(process, other) for other in alike):
            kept.append(process)
    return kept


def _same_memory(one: Process, other: Process) -> bool:
    """Tell whether two processes share their memory; False if unknown. Source: kcmp(2)."""
    first, second = (int(process.place.rpartition("/")[2]) for process in (one, other))
    return system_call(KCMP, first, second, KCMP_VM, 0, 0) == 0


def tables_mib(process: Process) -> float:
    """Return the memory of a process's page tables, which can exceed the memory they map."""
    lines = read(f"{process.place}/status").splitlines()
    return sum(int(line.split()[1]) for line in lines if line.startswith("VmPTE:")) / 1024


def _socket_bytes() -> int:
    """Return how many unread bytes a socket may hold; the kernel allows twice its setting."""
    return 2 * int(read("/proc/sys/net/core/wmem_default") or WMEM_DEFAULT_BYTES)
