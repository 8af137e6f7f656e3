"""How much memory a program's processes use together, where no control group tells.

Shared memory counts once. docs/security.md says how much the kernel holds that is not counted.
"""

from __future__ import annotations

import contextlib
import os
import platform
import time
from collections.abc import Mapping, Sequence

from judge.sandbox.keeper.proc import EXITING, FLAGS, LIBC, Process, fields, read

INODE_BYTES = 1024  # about what a file of a memory file system takes, with its name
SOCKET_BYTES = 2 * 212992  # unread ones: the kernel allows twice the default of its setting
WALL_MIB = 8.0  # the wall's own processes have less, unless the program has taken one over
EXACT_AT_MOST_S = 0.004  # at one sample; what is left is measured at the next one
KCMP, KCMP_VM = {"x86_64": 312, "aarch64": 272}, 1


class Memory:
    """Measures the memory of one program at every sample.

    scratch: the wall's memory file systems by place, with their sizes in bytes; empty
    without a wall. Their content counts, which no process shows.
    """

    def __init__(self, scratch: Mapping[str, int]) -> None:
        self._scratch = scratch
        self._exact_mib: dict[tuple[int, str], float] = {}  # in the pass that is under way

    def used_mib(self, live: Sequence[Process], limit_mib: float) -> float:
        """Return the memory in use by all of `live`, parents first; a lower bound at times.

        The resident memory of several processes counts what they share several times. So each is
        measured exactly, for some milliseconds at each sample, and the result is exact
        when all were measured. One process is measured only near the limit.
        """
        held_mib = self._held_mib(live)
        resident_mib = [process.resident_mib for process in live]
        largest_mib = max(resident_mib, default=0.0)
        used_mib = held_mib + largest_mib + sum(map(tables_mib, live))
        if sum(resident_mib) - largest_mib <= WALL_MIB and used_mib <= limit_mib:
            return used_mib
        give_up = time.monotonic() + EXACT_AT_MOST_S
        for process in live:
            if process.identity not in self._exact_mib and time.monotonic() < give_up:
                exact_mib = proportional_mib(process, bool(self._scratch))
                self._exact_mib[process.identity] = exact_mib
        if any(process.identity not in self._exact_mib for process in live):
            return held_mib + max(largest_mib, sum(self._exact_mib.values()))
        exact_mib = sum(self._exact_mib[process.identity] for process in distinct(live))
        self._exact_mib.clear()
        return held_mib + exact_mib

    def _held_mib(self, live: Sequence[Process]) -> float:
        """Return what the scratch file systems and sockets behind the wall hold, as seen there."""
        for process in live if self._scratch else ():
            with contextlib.suppress(OSError):
                seen = [os.statvfs(f"{process.place}/root{place}") for place in self._scratch]
                sizes = [each.f_blocks * each.f_frsize for each in seen]
                if sizes != list(self._scratch.values()):
                    continue  # it is outside the wall
                held = sum((each.f_blocks - each.f_bfree) * each.f_frsize for each in seen)
                held += sum((each.f_files - each.f_ffree) * INODE_BYTES for each in seen)
                sockets = read(f"{process.place}/net/sockstat").split()  # sockets: used 8 ...
                return (held + int(sockets[2]) * SOCKET_BYTES if sockets else held) / 2**20
        return 0.0


def proportional_mib(process: Process, without_scratch: bool) -> float:
    """Return the memory and page tables of a process; shared pages are divided among their users.

    without_scratch: leave out mapped files of memory file systems. If the process does not let
    others look, this is its resident memory, or 0 if it is exiting.
    """
    kib = _kib(f"{process.place}/smaps_rollup")
    if "Pss:" in kib:
        shared = kib.get("Pss_Shmem:", 0) if without_scratch else 0
        return (kib["Pss:"] - shared) / 1024 + tables_mib(process)
    stat = fields(process.place)
    return 0.0 if not stat or int(stat[FLAGS]) & EXITING else process.resident_mib


def tables_mib(process: Process) -> float:
    """Return the memory of a process's page tables, which can exceed the memory they map."""
    return _kib(f"{process.place}/status").get("VmPTE:", 0) / 1024


def _kib(path: str) -> dict[str, int]:
    """Return the figures of a file of lines `name number kB`."""
    lines = [line.split() for line in read(path).splitlines() if line.endswith(" kB")]
    return {name: int(number) for name, number, _ in lines}


def distinct(processes: Sequence[Process]) -> list[Process]:
    """Leave out processes that run in the memory of another, as between vfork and exec."""
    kept: list[Process] = []
    for process in processes:
        if not any(_same_memory(process, other) for other in kept):
            kept.append(process)
    return kept


def _same_memory(one: Process, other: Process) -> bool:
    """Tell whether two processes share their memory; False if unknown. Source: kcmp(2)."""
    first, second = (int(process.place.rpartition("/")[2]) for process in (one, other))
    call = KCMP.get(platform.machine(), -1)
    return bool(LIBC.syscall(call, first, second, KCMP_VM, 0, 0) == 0)
