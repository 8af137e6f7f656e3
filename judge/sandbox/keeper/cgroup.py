"""The control groups of a keeper and of what it runs, where this user may make some.

The keeper moves into them once, so every program is born there, and no process can leave. So the
kernel counts the CPU time of all of them, lists them, and, where the controllers are
enabled, limits their memory, its own included, and their number. Both versions of the interface
are supported: one directory for all controllers (v2), or one for each (v1).
Source: Linux, Documentation/admin-guide/cgroup-v2.rst, cgroup-v1/memory.rst, pids.rst
"""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

from judge.sandbox.keeper.proc import read

SLACK_MIB = 16.0  # for the wall's own processes; what is over the limit itself is sampled
UNLIMITED = -1
LEAF = "collision-course"  # where the judge itself is, if it had to move


class Cgroup:
    """The control groups of this process: none of `places` that the kernel refuses.

    places: where to make one, by controller (memory, pids, cpu); with v2 all are the same.
    Where there is none for a controller, its figures are None and its limits do nothing.
    """

    def __init__(self, places: dict[str, str], version: int) -> None:
        self._version = version
        self._of: dict[str, Path] = {}
        for controller, place in places.items():
            directory = Path(f"{place}-{os.getpid()}")
            try:
                directory.mkdir(exist_ok=True)
                write(directory / "cgroup.procs", os.getpid())
            except OSError:
                with contextlib.suppress(OSError):
                    directory.rmdir()
            else:
                self._of[controller] = directory
        if version == 2 and read(self._file("memory", "memory.max")) == "":
            self._of.pop("memory", None)  # there, but without this controller
        if version == 2 and read(self._file("pids", "pids.max")) == "":
            self._of.pop("pids", None)
        self._own_mib = self._began_mib = self._held_mib() or 0.0
        self._cpu_began_s = self._kills_began = 0.0

    @property
    def counts_cpu(self) -> bool:
        """Whether `cpu_s` counts."""
        return "cpu" in self._of

    def begin(self, memory_mib: int, processes: int) -> None:
        """Set the limits of the next program, and count from now on."""
        # What an earlier program has left does not raise the limit for long.
        self._own_mib = min(self._held_mib() or 0.0, self._began_mib + SLACK_MIB)
        most = int((memory_mib + SLACK_MIB + self._own_mib) * 2**20)
        if self._version == 2:
            self._set("memory", "memory.swap.max", 0)
            self._set("memory", "memory.max", most)
        else:
            # Memory and swap together may never be less than memory alone.
            self._set("memory", "memory.memsw.limit_in_bytes", UNLIMITED)
            self._set("memory", "memory.limit_in_bytes", most)
            self._set("memory", "memory.memsw.limit_in_bytes", most)
        self._set("pids", "pids.max", processes + 1)  # and the keeper
        self._cpu_began_s = self._cpu_s()
        self._kills_began = self._kills()

    def cpu_s(self) -> float:
        """Return the CPU seconds used since `begin`, the keeper's own included, if they count."""
        return self._cpu_s() - self._cpu_began_s

    def memory_mib(self) -> float | None:
        """Return the memory in use now besides the keeper's own: without caches of files."""
        held = self._held_mib()
        return None if held is None else max(0.0, held - self._own_mib)

    @property
    def out_of_memory(self) -> bool:
        """Whether the kernel killed a process because the memory was used up."""
        return self._kills() > self._kills_began

    def processes(self) -> list[int] | None:
        """Return the pids of all processes but the keeper, None if nothing lists them."""
        for directory in self._of.values():
            pids = [int(pid) for pid in read(directory / "cgroup.procs").split()]
            return [pid for pid in pids if pid != os.getpid()]
        return None

    def close(self) -> None:
        """Leave and remove the control groups; more than once does no harm."""
        for directory in dict.fromkeys(self._of.values()):
            # With version 2, no process may be in the parent while it has controllers enabled.
            for target in (directory.parent, directory.parent / LEAF):
                with contextlib.suppress(OSError):
                    write(target / "cgroup.procs", os.getpid())
                    break
            with contextlib.suppress(OSError):
                directory.rmdir()
        self._of = {}

    def _held_mib(self) -> float | None:
        """Return the memory that is not a cache of files: such caches go when memory is short."""
        current = "memory.current" if self._version == 2 else "memory.usage_in_bytes"
        used = read(self._file("memory", current))
        if not used:
            return None
        stat = _numbers(read(self._file("memory", "memory.stat")))
        cache = stat.get("file" if self._version == 2 else "total_cache", 0)
        shared = stat.get("shmem" if self._version == 2 else "total_shmem", 0)
        return (int(used) - max(0, cache - shared)) / 2**20

    def _cpu_s(self) -> float:
        if self._version == 2:
            return _numbers(read(self._file("cpu", "cpu.stat"))).get("usage_usec", 0) / 1e6
        return int(read(self._file("cpu", "cpuacct.usage")) or 0) / 1e9

    def _kills(self) -> int:
        file = "memory.events" if self._version == 2 else "memory.oom_control"
        return _numbers(read(self._file("memory", file))).get("oom_kill", 0)

    def _file(self, controller: str, name: str) -> Path:
        return self._of.get(controller, Path("/nonexistent")) / name

    def _set(self, controller: str, name: str, value: int) -> None:
        with contextlib.suppress(OSError):  # no such controller, or no accounting of swap
            write(self._file(controller, name), value)


def write(path: Path, value: int) -> None:
    """Write a number to a file of a control group. Raises OSError."""
    fd = os.open(path, os.O_WRONLY)
    try:
        os.write(fd, str(value).encode())
    finally:
        os.close(fd)


def _numbers(text: str) -> dict[str, int]:
    """Return the numbers of a file of lines `name number`."""
    pairs = (line.split() for line in text.splitlines())
    return {pair[0]: int(pair[1]) for pair in pairs if len(pair) == 2}
