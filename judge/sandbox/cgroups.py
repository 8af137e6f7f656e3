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

from judge.sandbox.keeper.cgroup import LEAF
from judge.sandbox.keeper.proc import read

CONTROLLERS = ("memory", "pids")  # to enable in version 2, which counts CPU time without one
OLD_CONTROLLERS = {"memory": "memory", "pids": "pids", "cpu": "cpuacct"}
END_TIMEOUT_S = 2.0


class Cgroups:
    """The places for control groups by controller: `places`, empty if there is none.

    Version 2: only a control group without processes of its own can enable controllers below it.
    If this process is the only one in its own, it moves into one below, LEAF, and back on close.
    Otherwise the new ones only count CPU time.
    process: this process's directory in /proc; None: make none.
    """

    def __init__(self, process: Path | None = Path("/proc/self")) -> None:
        self._moved = False
        self.places: dict[str, Path] = {}
        own = _own(process) if process else {}
        if "" in own and (below := self._enabled(own[""])):
            enabled = ["cpu", *read(below / "cgroup.subtree_control").split()]
            self.places = {use: below for use in OLD_CONTROLLERS if use in enabled}
        if "memory" not in self.places:
            old = {use: own[name] for use, name in OLD_CONTROLLERS.items() if name in own}
            usable = {use: place for use, place in old.items() if _may_make(place)}
            if "memory" in usable or not self.places:
                self.places = usable
        self.count_cpu = "cpu" in self.places
        self.hold_memory = "memory" in self.places

    def close(self, name: str) -> None:
        """Remove what killed keepers have left (names beginning with `name`), and move back."""
        give_up = time.monotonic() + END_TIMEOUT_S
        for place in dict.fromkeys(self.places.values()):
            while (left := list(place.glob(f"{name}-*"))) and time.monotonic() < give_up:
                for group in left:
                    with contextlib.suppress(OSError):  # a process is still ending
                        group.rmdir()
                time.sleep(0.002)
        if self._moved:
            below = self.places["cpu"]
            _enable(below, "-")
            self._moved = not _move(below)
            with contextlib.suppress(OSError):
                (below / LEAF).rmdir()

    def _enabled(self, own: Path) -> Path | None:
        """Return the place in version 2, controllers enabled if possible; None if there is none."""
        if own.name == LEAF:  # moved already
            return own.parent
        if not _may_make(own):
            return None
        alone = read(own / "cgroup.procs").split() == [str(os.getpid())]
        if not _enable(own, "+") and alone:
            self._moved = _move(own / LEAF)
            _enable(own, "+")
        return own


def _enable(directory: Path, sign: str) -> bool:
    """Enable the controllers below (+) or disable them (-); return whether that worked."""
    try:
        there = (directory / "cgroup.controllers").read_text().split()
        wanted = " ".join(f"{sign}{name}" for name in CONTROLLERS if name in there)
        if wanted:
            (directory / "cgroup.subtree_control").write_text(wanted)
    except OSError:
        return False
    return True


def _move(target: Path) -> bool:
    """Move this process to a control group; return whether that worked."""
    try:
        target.mkdir(exist_ok=True)
        (target / "cgroup.procs").write_text(str(os.getpid()))
    except OSError:
        return False
    return True


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
    return all(os.access(path, os.W_OK) for path in (directory, directory / "cgroup.procs"))
