"""Control groups: where this user may make some, and those of a keeper and of what it runs.

A keeper moves into them once, so every program is born there, and no process can leave. The
kernel counts their CPU time, lists them, and limits their memory, its own included, and number.
Version 2 has one directory for all controllers, version 1 one for each, with other files.
Source: Linux, Documentation/admin-guide/cgroup-v2.rst, cgroup-v1/memory.rst, pids.rst
"""

from __future__ import annotations

import contextlib
import os
import time
from pathlib import Path

from judge.sandbox.keeper.proc import read

ENABLE, DISABLE = "+memory +pids", "-memory -pids"  # version 2 counts CPU time without a controller
CONTROLLERS = {"memory": "memory", "pids": "pids", "cpu": "cpuacct"}  # of version 1, by use
PROCESSES, CONTROL = "cgroup.procs", "cgroup.subtree_control"
LEAF = "collision-course"  # where the judge itself is, if it had to move
SLACK_MIB = 16.0  # for the wall's own processes; what is over the limit itself is sampled
UNLIMITED = -1
END_TIMEOUT_S = 2.0


class Cgroups:
    """Where the judge may make them: `places` by use (memory, pids, cpu), empty if one is missing.

    That is below its own control groups: with version 1 if it is root, with version 2 if its own
    one was delegated to its user. There, only a control group without processes of its own can
    enable controllers below it. If this process is the only one in its own, it moves into one
    below, LEAF, and back on close.
    process: this process's directory in /proc; None: make none.
    """

    def __init__(self, process: Path | None = Path("/proc/self")) -> None:
        self._moved: Path | None = None  # where it moved
        own = _own(process) if process else {}
        own = {name: place for name, place in own.items() if _may_make(place)}
        self.places: dict[str, Path] = {}
        if own.keys() >= set(CONTROLLERS.values()):
            self.places = {use: own[name] for use, name in CONTROLLERS.items()}
        elif "" in own and (place := self._enabled(own[""])):
            self.places = dict.fromkeys(CONTROLLERS, place)

    def close(self, name: str) -> None:
        """Remove what killed keepers have left (names beginning with `name`), and move back."""
        give_up = time.monotonic() + END_TIMEOUT_S
        for place in set(self.places.values()):
            while (left := list(place.glob(f"{name}-*"))) and time.monotonic() < give_up:
                for group in left:
                    with contextlib.suppress(OSError):  # a process is still ending
                        group.rmdir()
                time.sleep(0.002)
        if self._moved:
            leave(self._moved)
        self._moved = None

    def _enabled(self, own: Path) -> Path | None:
        """Return the place in version 2 with its controllers enabled, None if that is refused."""
        if own.name == LEAF:  # moved already
            return own.parent
        if written(own / CONTROL, ENABLE):
            return own
        if read(own / PROCESSES).split() == [str(os.getpid())] and entered(own / LEAF):
            self._moved = own / LEAF
            return own if written(own / CONTROL, ENABLE) else None
        return None


class Cgroup:
    """The control groups of this process.

    places: where to make them, by use (memory, pids, cpu); with version 2 all are the same.
    there: whether the kernel made them. Otherwise all figures are 0, and the limits do nothing.
    """

    def __init__(self, places: dict[str, str]) -> None:
        self._of = {use: Path(f"{place}-{os.getpid()}") for use, place in places.items()}
        if not all(map(entered, self._of.values())):
            self.close()
            self._of = {}
        self.there = bool(self._of)
        self._own_mib = self._began_mib = self._held_mib()
        self._cpu_began_s = self._kills_began = 0.0

    def begin(self, memory_mib: int, processes: int) -> None:
        """Set the limits of the next program, and count from now on."""
        # What an earlier program has left does not raise the limit for long.
        self._own_mib = min(self._held_mib(), self._began_mib + SLACK_MIB)
        most = int((memory_mib + SLACK_MIB + self._own_mib) * 2**20)
        for use, name, value in (
            ("pids", "pids.max", processes + 1),  # and the keeper
            ("memory", "memory.swap.max", 0),
            ("memory", "memory.max", most),
            # In version 1, memory and swap together may never be less than memory alone.
            ("memory", "memory.memsw.limit_in_bytes", UNLIMITED),
            ("memory", "memory.limit_in_bytes", most),
            ("memory", "memory.memsw.limit_in_bytes", most),
        ):
            if self.there:
                written(self._of[use] / name, value)  # False for a file of the other version
        self._cpu_began_s = self._cpu_s()
        self._kills_began = self._kills()

    def cpu_s(self) -> float:
        """Return the CPU seconds used since `begin`, the keeper's own included."""
        return self._cpu_s() - self._cpu_began_s

    def memory_mib(self) -> float:
        """Return the memory in use now besides the keeper's own: without caches of files."""
        return max(0.0, self._held_mib() - self._own_mib)

    @property
    def out_of_memory(self) -> bool:
        """Whether the kernel killed a process because the memory was used up."""
        return self._kills() > self._kills_began

    def processes(self) -> int:
        """Return the number of processes besides the keeper."""
        return len(self._read("memory", PROCESSES).split()) - 1

    def close(self) -> None:
        """Leave and remove the control groups."""
        for directory in set(self._of.values()):
            leave(directory)

    def _held_mib(self) -> float:
        """Return the memory that is not a cache of files: such caches go when memory is short."""
        used = self._read("memory", "memory.current", "memory.usage_in_bytes") or "0"
        stat = _numbers(self._read("memory", "memory.stat"))
        cache = stat.get("total_cache", stat.get("file", 0))
        shared = stat.get("total_shmem", stat.get("shmem", 0))
        return (int(used) - max(0, cache - shared)) / 2**20

    def _cpu_s(self) -> float:
        used = _numbers(self._read("cpu", "cpu.stat")).get("usage_usec", 0) / 1e6
        return used or int(self._read("cpu", "cpuacct.usage") or 0) / 1e9

    def _kills(self) -> int:
        events = self._read("memory", "memory.events", "memory.oom_control")
        return _numbers(events).get("oom_kill", 0)

    def _read(self, use: str, *names: str) -> str:
        """Return the text of whichever file exists, empty if none does."""
        texts = (read(self._of[use] / name) for name in names if self._of)
        return next(filter(None, texts), "")


def entered(directory: Path) -> bool:
    """Make a control group if it is not there, and enter it; return whether that worked."""
    with contextlib.suppress(OSError):
        directory.mkdir(exist_ok=True)
    return written(directory / PROCESSES, os.getpid())


def leave(directory: Path) -> None:
    """Leave a control group and remove it; the last one that leaves removes LEAF beside it, too.

    That is the judge, or if it was killed, a keeper.
    """
    parent, leaf = directory.parent, directory.parent / LEAF
    if leaf.is_dir() and read(leaf / PROCESSES).split() in ([], [str(os.getpid())]):
        written(parent / CONTROL, DISABLE)
    # With version 2, no process may be in the parent while it has controllers enabled.
    if not written(parent / PROCESSES, os.getpid()):
        written(leaf / PROCESSES, os.getpid())
    for empty in (directory, leaf):
        with contextlib.suppress(OSError):
            empty.rmdir()


def written(path: Path, value: int | str) -> bool:
    """Write to a file of a control group; return whether the kernel took it."""
    try:
        with path.open("r+b", buffering=0) as file:
            file.write(str(value).encode())
    except OSError:
        return False
    return True


def _numbers(text: str) -> dict[str, int]:
    """Return the numbers of a file of lines `name number`."""
    pairs = (line.split() for line in text.splitlines())
    return {pair[0]: int(pair[1]) for pair in pairs if len(pair) == 2}


def _own(process: Path) -> dict[str, Path]:
    """Return the directories of the process's control groups by controller, "" for version 2."""
    mounted: dict[str, tuple[str, str]] = {}
    for mount in read(process / "mountinfo").splitlines():
        before, _, after = mount.partition(" - ")
        root, place = before.split(" ")[3:5]
        kind, _, options = after.split(" ", 2)
        names = [""] if kind == "cgroup2" else options.split(" ")[-1].split(",")
        if kind in ("cgroup", "cgroup2"):
            mounted |= dict.fromkeys(names, (root, place))
    found = {}
    for line in read(process / "cgroup").splitlines():
        _, names_here, own = line.split(":", 2)
        for name in names_here.split(","):
            root, place = mounted.get(name, ("", ""))
            if root and Path(own).is_relative_to(root):
                found[name] = Path(place) / Path(own).relative_to(root)
    return found


def _may_make(directory: Path) -> bool:
    return all(os.access(path, os.W_OK) for path in (directory, directory / PROCESSES))
