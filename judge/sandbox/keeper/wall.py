"""The keeper's side of the wall: in the child, between fork and exec, become `bwrap`.

Run by root, the program must not be root: an unprivileged user is dropped to first, so
that resource limits hold. That user may not be able to walk to what it shall see (a home
directory is closed to others), so root binds it to a place of its own beforehand, in a
mount namespace that nobody else sees.
"""

from __future__ import annotations

import ctypes
import os
from pathlib import Path
from typing import Any

from judge.sandbox.keeper.libc import LIBC

NOBODY = 65534
CLONE_NEWNS = 0x20000
MS_BIND, MS_REC, MS_PRIVATE, MS_NOSUID, MS_NODEV = 0x1000, 0x4000, 0x40000, 2, 4
STAGE = "/tmp"  # every system has it; hidden here by a mount of its own
# RLIMIT_NPROC counts the processes of the inner user namespace only when set in there.
# dash and bash call it differently.
# Its first act says that the wall stands: only then is the program to blame for its end.
STARTED = 9  # one digit: dash knows no other descriptors
INNER = 'echo >&9; exec 9>&-; ulimit -u "$0" 2>/dev/null || ulimit -p "$0"; exec "$@"'


def walled(wall: dict[str, Any], argv: list[str], processes: int) -> tuple[str, list[str]]:
    """Prepare the wall in this process; return the path of bwrap and its arguments.

    wall: bwrap, its path; args: what it is told besides the binds; binds: triples of
    source, destination, and whether it is writable; seccomp: the filter in hexadecimal.
    (scratch, what its memory file systems are, is `tree.Tree`'s to know.) Raises OSError.
    """
    bwrap = wall["bwrap"]
    sources = [source for source, _, _ in wall["binds"]]
    if os.getuid() == 0:
        # A packaged bwrap loads a library that lies beside its package: it needs both.
        packages = Path(bwrap).parents[2]
        own = [] if packages == Path("/") else [str(packages)]
        if not all(map(open_to_all, [*sources, *own])):
            staged = stage([*sources, *own])
            sources = staged[: len(sources)]
            if own:
                bwrap = f"{staged[-1]}/{Path(bwrap).relative_to(packages)}"
        drop()
    args = list(wall["args"])
    for source, (_, destination, writable) in zip(sources, wall["binds"], strict=True):
        args += ["--bind" if writable else "--ro-bind", source, destination]
    seccomp = inherited(bytes.fromhex(wall["seccomp"]))
    args += ["--seccomp", str(seccomp), "--remount-ro", "/"]
    # From a descriptor, as the command line can be read from inside.
    told = inherited(b"".join(arg.encode() + b"\0" for arg in args))
    inner = ["/bin/sh", "-c", INNER, str(processes), *argv]
    return bwrap, ["bwrap", "--args", str(told), "--", *inner]


def drop() -> None:
    """Become, from root, a user who owns nothing."""
    os.setgroups([])
    os.setresgid(NOBODY, NOBODY, NOBODY)
    os.setresuid(NOBODY, NOBODY, NOBODY)


def open_to_all(path: str) -> bool:
    """May every user walk to `path`? A new mount namespace is not cheap."""
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
