"""The keeper's side of the wall: what the child needs, between fork and exec, for bubblewrap.

Resource limits do not bind root, so a child of root becomes an unprivileged user first. That
user may be unable to reach the program's files (a home directory is closed to others), so
before that, root binds them to other places in a private mount namespace.
"""

from __future__ import annotations

import ctypes
import os
from collections.abc import Sequence
from pathlib import Path

from judge.sandbox.keeper.proc import LIBC
from judge.sandbox.keeper.protocol import WallRequest

CLONE_NEWNS = 0x20000
MS_BIND, MS_REC, MS_PRIVATE, MS_NOSUID, MS_NODEV = 0x1000, 0x4000, 0x40000, 2, 4
STAGE = "/sys"  # every system has it, and a private mount covers nothing there that is needed
# RLIMIT_NPROC counts the processes of a user namespace only if it is set inside; dash and bash
# name it differently. The first command tells the keeper that the wall stands. A shell reads no
# more of a pipe than the line that it was told to.
REPORT = 9  # dash knows only descriptors of one digit
INNER = 'echo >&9; exec 9>&-; ulimit -u "$0" 2>/dev/null || ulimit -p "$0"; read -r _; exec "$@"'
GO = b"\n"


def walled(wall: WallRequest, argv: Sequence[str], processes: int) -> list[str]:
    """Return the arguments of bubblewrap, with which it inherits open files."""
    seccomp = _inherited(bytes.fromhex(wall.seccomp))
    args = ("--seccomp", str(seccomp), *wall.args)
    # Passed through a descriptor, because the program could read a command line.
    told = _inherited("".join(f"{arg}\0" for arg in args).encode())
    return ["bwrap", "--args", str(told), "--", "/bin/sh", "-c", INNER, str(processes), *argv]


def open_to_all(path: str | Path, below: str | Path = "/") -> bool:
    """Tell whether every user who reaches `below` can reach `path`."""
    parents = [parent for parent in Path(path).parents if parent.is_relative_to(below)]
    return all(parent.stat().st_mode & 0o001 for parent in parents)


def stage(sources: Sequence[str]) -> None:
    """Bind each of `sources` below STAGE, as 0, 1, ..., in a new mount namespace.

    Raises OSError.
    """
    if not sources:
        return
    _check(LIBC.unshare(CLONE_NEWNS), "unshare")
    _mount("none", "/", "", MS_REC | MS_PRIVATE)
    _mount("stage", STAGE, "tmpfs", MS_NOSUID | MS_NODEV)
    Path(STAGE).chmod(0o755)
    for number, source in enumerate(sources):
        target = Path(STAGE, str(number))
        target.mkdir()
        _mount(source, str(target), "", MS_BIND)


def _mount(source: str, target: str, kind: str, flags: int) -> None:
    done = LIBC.mount(source.encode(), target.encode(), kind.encode(), flags, None)
    _check(done, f"mount {source}")


def _check(done: int, what: str) -> None:
    if done:
        error = ctypes.get_errno()
        raise OSError(error, f"{what}: {os.strerror(error)}")


def _inherited(content: bytes) -> int:
    """Return a descriptor that survives exec and reads as `content`."""
    fd = os.memfd_create("wall", 0)
    os.write(fd, content)
    os.lseek(fd, 0, os.SEEK_SET)
    return fd
