"""How much memory the processes of a program use together: nothing twice, nothing forgotten."""

from __future__ import annotations

import ctypes
import os
import platform
from collections.abc import Mapping, Sequence

from judge.keeper.proc import EXITING, FLAGS, Process, fields, read

INODE_BYTES = 1024  # of a memory file system, its name included; about
WMEM_DEFAULT_BYTES = 212992  # of most kernels
TABLES_MATTER_MIB = 4096.0  # of addresses; whoever has fewer has at most 8 MiB of tables
WALL_PROCESSES = 2  # one outside, and the first within
WALL_MIB = 8.0  # more than either has, unless the program has taken it over
SHARED_EVERY = 10  # looks
KCMP, KCMP_VM = {"x86_64": 312, "aarch64": 272}, 1
LIBC = ctypes.CDLL(None, use_errno=True)


class Memory:
    """Looks at the memory of a program again and again.

    scratch: the sizes in bytes of the wall's memory file systems by their places, empty
    without a wall. What they hold is the program's, and no process shows it.
    """

    def __init__(self, scratch: Mapping[str, int]) -> None:
        self._scratch = scratch
        self._looks = 0

    def used_mib(self, live: Sequence[Process], limit_mib: float) -> float:
        """Return the memory in use by all of `live`, parents first.

        To find out what is shared is slow: it is done now and then, and whenever it decides.
        Otherwise this is, for several processes, what there is at least.
        """
        self._looks += 1
        walls = live[: WALL_PROCESSES if self._scratch else 0]
        own = [process for process in walls if process.resident_mib > WALL_MIB]
        own = [*own, *live[len(walls) :]] or list(live)
        beyond_mib = self._held_mib(live) + _tables_mib(own)
        resident_mib = [process.resident_mib for process in own]
        several = len(own) > 1
        if sum(resident_mib) + beyond_mib > limit_mib or (several and self._is_time()):
            # Of scratch, what is mapped is held already.
            return sum(proportional_mib(p, bool(self._scratch)) for p in distinct(own)) + beyond_mib
        return (max(resident_mib) if several else sum(resident_mib)) + beyond_mib

    def _is_time(self) -> bool:
        return self._looks % SHARED_EVERY == 1

    def _held_mib(self, live: Sequence[Process]) -> float:
        """Return what file systems and sockets behind the wall hold, as whoever is there sees them.

        A file system of another size is not ours: the wall is not built to its end yet, and
        the process still sees this machine's own.
        """
        for process in live if self._scratch else ():
            held = 0
            for place, size in self._scratch.items():
                try:
                    seen = os.statvfs(f"{process.place}/root{place}")
                except OSError:
                    break
                if seen.f_blocks * seen.f_frsize != size:
                    break
                held += (seen.f_blocks - seen.f_bfree) * seen.f_frsize
                held += (seen.f_files - seen.f_ffree) * INODE_BYTES
            else:
                sockets = read(f"{process.place}/net/sockstat").split()  # sockets: used 8 ...
                return (held + (int(sockets[2]) * _socket_bytes() if sockets else 0)) / 2**20
        return 0.0


def proportional_mib(process: Process, without_scratch: bool) -> float:
    """Return the memory of a process with every shared page divided among its users.

    without_scratch: leave out mapped files of memory file systems. A process may keep others
    from looking: then it is what is resident, unless it is ending and has nothing any more.
    """
    lines = read(f"{process.place}/smaps_rollup").splitlines()
    kib = {line.split()[0]: int(line.split()[1]) for line in lines if line.endswith(" kB")}
    if "Pss:" in kib:
        return (kib["Pss:"] - (kib.get("Pss_Shmem:", 0) if without_scratch else 0)) / 1024
    stat = fields(process.place)
    return 0.0 if not stat or int(stat[FLAGS]) & EXITING else process.resident_mib


def distinct(processes: Sequence[Process]) -> list[Process]:
    """Leave out who uses the very memory of another, as a child does between vfork and exec."""
    kept: list[Process] = []
    for process in processes:
        alike = (other for other in kept if other.mapped_mib == process.mapped_mib)
        if not any(_same_memory(process, other) for other in alike):
            kept.append(process)
    return kept


def _same_memory(one: Process, other: Process) -> bool:
    """Source: kcmp(2). Where the kernel does not tell, they are not the same."""
    number = KCMP.get(platform.machine())
    if number is None:
        return False
    first, second = (int(process.place.rpartition("/")[2]) for process in (one, other))
    return bool(LIBC.syscall(number, first, second, KCMP_VM, 0, 0) == 0)


def _tables_mib(processes: Sequence[Process]) -> float:
    """Return the memory that only says where memory is: it may be more than the memory."""
    if sum(process.mapped_mib for process in processes) < TABLES_MATTER_MIB:
        return 0.0
    lines = (line for p in processes for line in read(f"{p.place}/status").splitlines())
    return sum(int(line.split()[1]) for line in lines if line.startswith("VmPTE:")) / 1024


def _socket_bytes() -> int:
    """Return what a socket may hold that nobody has read; the kernel lets it be twice of this."""
    return 2 * int(read("/proc/sys/net/core/wmem_default") or WMEM_DEFAULT_BYTES)
