"""The keeper's side of the wall: the child, between fork and exec, becomes bubblewrap.

Resource limits do not bind root, so a child of root becomes an unprivileged user first. That
user may be unable to reach the program's files (a home directory is closed to others), so
before that, root binds them to other places in a private mount namespace.
"""

from __future__ import annotations

import ctypes
import os
from pathlib import Path

from judge.sandbox.keeper.proc import LIBC
from judge.sandbox.keeper.protocol import WallRequest

CLONE_NEWNS = 0x20000
MS_BIND, MS_REC, MS_PRIVATE, MS_NOSUID, MS_NODEV = 0x1000, 0x4000, 0x40000, 2, 4
STAGE = "/tmp"  # every system has it; a private mount covers it
# RLIMIT_NPROC counts the processes of a user namespace only if it is set inside; dash and bash
# name it differently. The first command tells the keeper that the wall stands: whatever fails
# later is the program's fault. A shell reads no more of a pipe than the line that it was told to.
STARTED = 9  # dash knows only descriptors of one digit
INNER = 'echo >&9; exec 9>&-; ulimit -u "$0" 2>/dev/null || ulimit -p "$0"; read -r _; exec "$@"'
GO = b"\n"


def walled(
    wall: WallRequest, argv: list[str], processes: int, user: int | None
) -> tuple[str, list[str]]:
    """Prepare the wall in this process; return the path of bubblewrap and its arguments.

    Raises OSError.
    """
    bwrap = wall.bwrap
    sources = [source for source, _, _ in wall.binds]
    if user is not None:
        # A packaged bwrap loads a library that lies beside its package: it needs both.
        packages = Path(bwrap).parents[2]
        own = [] if packages == Path("/") else [str(packages)]
        if not all(map(open_to_all, [*sources, *own])):
            staged = stage([*sources, *own])
            sources = staged[: len(sources)]
            if own:
                bwrap = f"{staged[-1]}/{Path(bwrap).relative_to(packages)}"
        become_user(user)
    args = list(wall.args)
    for source, (_, destination, writable) in zip(sources, wall.binds, strict=True):
        args += ["--bind" if writable else "--ro-bind", source, destination]
    seccomp = inherited(bytes.fromhex(wall.seccomp))
    args += ["--seccomp", str(seccomp), "--remount-ro", "/"]
    # Passed through a descriptor, because the program could read a command line.
    told = inherited(b"".join(arg.encode() + b"\0" for arg in args))
    inner = ["/bin/sh", "-c", INNER, str(processes), *argv]
    return bwrap, ["bwrap", "--args", str(told), "--", *inner]


def become_user(user: int) -> None:
    """Change from root to a user who owns nothing."""
    os.setgroups([])
    os.setresgid(user, user, user)
    os.setresuid(user, user, user)


def open_to_all(path: str) -> bool:
    """Tell whether every user can reach `path`. Otherwise a mount namespace, slow, is needed."""
    return all(parent.stat().st_mode & 0o001 for parent in Path(path).parents)


def stage(sources: list[str]) -> list[str]:
    """Bind each of `sources` below STAGE, in a new mount namespace; return the new paths."""

    def mount(source: str, target: str, kind: str, flags: int) -> None:
        if LIBC.mount(source.encode(), target.encode(), kind.encode(), flags, None):
            error = ctypes.get_errno()
            raise OSError(error, f"mount {source}: {os.strerror(error)}")

    if LIBC.unshare(CLONE_NEWNS):
        error = ctypes.get_errno()
        raise OSError(error, f"unshare: {os.strerror(error)}")
    mount("none", "/", "", MS_REC | MS_PRIVATE)
    opened = [os.open(source, os.O_PATH) for source in sources]  # before STAGE hides any
    mount("stage", STAGE, "tmpfs", MS_NOSUID | MS_NODEV)
    staged = []
    for number, fd in enumerate(opened):
        target = f"{STAGE}/{number}"
        Path(target).mkdir()
        mount(f"/proc/self/fd/{fd}", target, "", MS_BIND)
        os.close(fd)
        staged.append(target)
    Path(STAGE).chmod(0o755)
    return staged


def inherited(content: bytes) -> int:
    """Return a descriptor that survives exec and reads as `content`."""
    fd = os.memfd_create("wall", 0)
    os.write(fd, content)
    os.lseek(fd, 0, os.SEEK_SET)
    return fd
