"""Finds the place where this process may make control groups (cgroup v2), if there is one.

A process may make them below its own control group if that was delegated to its user, as by
`systemd-run --user --scope -p Delegate=yes ./checker.py ...`, or if it is root and nothing
forbids it. `judge.sandbox.keeper.cgroup` makes them.
"""

from __future__ import annotations

import contextlib
import os
import secrets
import time
from pathlib import Path

from judge.sandbox.keeper.proc import read
from judge.sandbox.keeper.protocol import CgroupRequest

CONTROLLERS = ("memory", "pids")
LEAF = "collision-course"
END_TIMEOUT_S = 2.0


class Cgroups:
    """The control group in which others can be made: `directory`, None if there is none.

    A control group can enable controllers for those below it only if it holds no process. If
    this process is alone in its control group, it moves into a new one below it, LEAF, and
    moves back on `close`. Otherwise the new control groups have no controllers: they count CPU
    time and can kill processes, but limit nothing.

    process: this process's directory in /proc.
    """

    def __init__(self, process: Path = Path("/proc/self")) -> None:
        self._moved = self._limits = False
        self.directory = _own_group(process)
        if self.directory is None:
            return
        if self.directory.name == LEAF:  # moved already
            self.directory = self.directory.parent
        elif not _may_make_groups(self.directory):
            self.directory = None
        elif not self._pass_on_controllers("+") and self._alone():
            self._moved = self._move(self.directory / LEAF)
            if self._moved:
                self._pass_on_controllers("+")
        if self.directory is not None:
            passed_on = read(self.directory / "cgroup.subtree_control").split()
            self._limits = any(name in passed_on for name in CONTROLLERS)

    def request(self, name: str) -> CgroupRequest | None:
        """Return what a keeper needs to make control groups `name-…`; None: it cannot make any."""
        if self.directory is None:
            return None
        return CgroupRequest(str(self.directory / name), self._limits)

    def close(self, name: str) -> None:
        """Remove the control groups `name-…` that a killed keeper has left, and undo the move."""
        if self.directory is None:
            return
        give_up = time.monotonic() + END_TIMEOUT_S
        while (left := list(self.directory.glob(f"{name}-*"))) and time.monotonic() < give_up:
            for group in left:
                with contextlib.suppress(OSError):  # a process is still ending
                    group.rmdir()
            time.sleep(0.002)
        if self._moved:
            self._pass_on_controllers("-")
            self._moved = not self._move(self.directory)
            with contextlib.suppress(OSError):
                (self.directory / LEAF).rmdir()

    def _pass_on_controllers(self, sign: str) -> bool:
        """Enable the controllers below (+) or disable them (-); return whether that worked."""
        assert self.directory is not None
        try:
            there = (self.directory / "cgroup.controllers").read_text().split()
            wanted = " ".join(f"{sign}{name}" for name in CONTROLLERS if name in there)
            if wanted:
                (self.directory / "cgroup.subtree_control").write_text(wanted)
        except OSError:
            return False
        return True

    def _alone(self) -> bool:
        assert self.directory is not None
        processes = read(self.directory / "cgroup.procs").split()
        return processes == [str(os.getpid())]

    def _move(self, target: Path) -> bool:
        try:
            target.mkdir(exist_ok=True)
            (target / "cgroup.procs").write_text(str(os.getpid()))
        except OSError:
            return False
        return True


def _own_group(process: Path) -> Path | None:
    """Return the directory of the process's control group, None if cgroup v2 is not mounted."""
    mounts = read(process / "mountinfo").splitlines()
    groups = read(process / "cgroup").splitlines()
    own = [line.removeprefix("0::") for line in groups if line.startswith("0::")]
    for mount in mounts:
        before, _, after = mount.partition(" - ")
        if own and after.split(" ")[0] == "cgroup2":
            root, place = before.split(" ")[3:5]
            if Path(own[0]).is_relative_to(root):
                return Path(place) / Path(own[0]).relative_to(root)
    return None


def _may_make_groups(directory: Path) -> bool:
    """Tell by trying, because file modes do not show that a file system is read-only."""
    trial = directory / f"{LEAF}-{secrets.token_hex(8)}"
    try:
        trial.mkdir()
        trial.rmdir()
    except OSError:
        return False
    return os.access(directory / "cgroup.procs", os.W_OK)
