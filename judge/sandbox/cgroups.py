"""Finds where this process may make control groups, if anywhere.

With version 2 it may do so below its own one if that was delegated to its user, as systemd does
for `systemd-run --user --scope -p Delegate=yes ./checker.py ...`, or if it is root and nothing
forbids it. With version 1 it is root. Keepers make them: `judge.sandbox.keeper.cgroup`.
"""

from __future__ import annotations

import contextlib
import os
import time
from pathlib import Path

from judge.sandbox.keeper.cgroup import CONTROL, DISABLE, LEAF, PROCESSES, written
from judge.sandbox.keeper.proc import read

ENABLE = "+memory +pids"  # version 2 counts CPU time without a controller
CONTROLLERS = {"memory": "memory", "pids": "pids", "cpu": "cpuacct"}  # of version 1, by use
END_TIMEOUT_S = 2.0


class Cgroups:
    """The places for control groups by use (memory, pids, cpu): `places`, empty if one is missing.

    Version 2: only a control group without processes of its own can enable controllers below it.
    If this process is the only one in its own, it moves into one below, LEAF, and back on close.
    process: this process's directory in /proc; None: make none.
    """

    def __init__(self, process: Path | None = Path("/proc/self")) -> None:
        self._left: Path | None = None
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
        if self._left:
            written(self._left / CONTROL, DISABLE)
            if written(self._left / PROCESSES, os.getpid()):
                with contextlib.suppress(OSError):
                    (self._left / LEAF).rmdir()
                self._left = None

    def _enabled(self, own: Path) -> Path | None:
        """Return the place in version 2 with its controllers enabled, None if that is refused."""
        if own.name == LEAF:  # moved already
            return own.parent
        if written(own / CONTROL, ENABLE):
            return own
        if read(own / PROCESSES).split() == [str(os.getpid())]:
            with contextlib.suppress(OSError):
                (own / LEAF).mkdir(exist_ok=True)
            if written(own / LEAF / PROCESSES, os.getpid()):
                self._left = own
                return own if written(own / CONTROL, ENABLE) else None
        return None


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
