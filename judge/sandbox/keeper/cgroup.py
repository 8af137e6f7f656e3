"""A control group (cgroup v2) of its own for one program, where this user may make one.

A process cannot leave its control group. So the kernel counts all CPU time there, kills all
processes at once, and, where the controllers are enabled, limits memory and processes even
between two samples. The keeper also works without a control group.
Source: the kernel's Documentation/admin-guide/cgroup-v2.rst
"""

from __future__ import annotations

import contextlib
import os
from pathlib import Path

from judge.sandbox.keeper.proc import read

SLACK_MIB = 16  # for page tables and the wall; samples enforce the exact limit


class Cgroup:
    """The control group of the process `pid`, which must not have started another yet.

    directory: where to make it. If that is None, or the kernel refuses, no method does anything.
    """

    def __init__(self, directory: str | None, pid: int, memory_mib: int, processes: int) -> None:
        self._directory = None if directory is None else Path(directory)
        if self._directory is None:
            return
        try:
            self._directory.mkdir()
            for file, value in (
                ("memory.max", (memory_mib + SLACK_MIB) << 20),
                ("memory.swap.max", 0),
                ("memory.oom.group", 1),
                ("pids.max", processes),
            ):
                with contextlib.suppress(FileNotFoundError, PermissionError):  # no controller
                    self._write(file, value)
            self._write("cgroup.procs", pid)
        except OSError:
            self.close()

    def cpu_s(self) -> float:
        """Return the CPU seconds used so far, 0 without a control group."""
        for line in self._read("cpu.stat").splitlines():
            if line.startswith("usage_usec "):
                return int(line.split()[1]) / 1e6
        return 0.0

    @property
    def out_of_memory(self) -> bool:
        """Whether the kernel killed a process because the memory was used up."""
        lines = self._read("memory.events").splitlines()
        return any(line.startswith("oom_kill ") and line != "oom_kill 0" for line in lines)

    def kill(self) -> None:
        """Kill every process in the control group."""
        with contextlib.suppress(OSError):  # before Linux 5.14 there is no such file
            self._write("cgroup.kill", 1)

    def close(self) -> None:
        """Remove it; all its processes must be reaped. May be called more than once."""
        if self._directory is not None:
            with contextlib.suppress(OSError):
                self._directory.rmdir()
            self._directory = None

    def _write(self, file: str, value: int) -> None:
        if self._directory is not None:
            fd = os.open(self._directory / file, os.O_WRONLY)
            try:
                os.write(fd, str(value).encode())
            finally:
                os.close(fd)

    def _read(self, file: str) -> str:
        return "" if self._directory is None else read(self._directory / file)
