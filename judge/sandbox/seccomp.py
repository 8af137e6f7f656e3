"""The system-call filter of the wall, assembled here without a library.

Refused calls fail with EPERM; those whose arguments the filter cannot see fail with ENOSYS, so
that libraries use older ones. Children of a process that ignores SIGCHLD are not charged to it.
So unless a control group counts CPU time, no program may ignore it: the call seems to succeed.
Source: Linux, Documentation/userspace-api/seccomp_filter.rst; linux/filter.h.
"""

from __future__ import annotations

import errno
import struct
import tomllib
from pathlib import Path

AUDIT_ARCH = {"x86_64": 0xC000003E, "aarch64": 0xC00000B7}
CALLS = Path(__file__).with_name("calls.toml")
NAMESPACES = 0x7E020000  # CLONE_NEWNS, NEWCGROUP, NEWUTS, NEWIPC, NEWUSER, NEWPID, NEWNET
MAP_SHARED, MAP_ANONYMOUS = 0x01, 0x20
TYPING = (0x5412, 0x541C)  # of ioctl: TIOCSTI, TIOCLINUX
SIGCHLD = 17
# Of prctl: PR_SET_DUMPABLE hides memory; PR_FUTEX_HASH takes memory that no process shows.
PRCTL_REFUSED = (4, 78)
# Of fcntl: F_SETLK, F_SETLKW and both for open files, F_SETLEASE; F_SETPIPE_SZ. With locks on
# files of the system, two runs could see each other.
FCNTL_REFUSED = (6, 7, 37, 38, 1024, 1031)
X32_BIT = 0x40000000

Instruction = tuple[int, int, int, int]
LOAD, JUMP_EQ, JUMP_GE, JUMP_SET, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
# Offsets in struct seccomp_data. An argument is a low word, then, at HIGH, a high one.
NUMBER, ARCH, ARGUMENTS, ARGUMENT_BYTES, HIGH = 0, 4, 16, 8, 4
ALLOW: Instruction = (RETURN, 0, 0, 0x7FFF0000)
KILL: Instruction = (RETURN, 0, 0, 0x80000000)


def filter_program(machine: str, *, compiling: bool = False, counted: bool = False) -> bytes:
    """Return the filter for a machine (`x86_64`, `aarch64`). Raises KeyError for another.

    compiling: for a compiler, which may lock files. counted: a control group counts CPU time.
    """
    if machine not in AUDIT_ARCH:
        raise KeyError(f"no system-call filter for {machine}")
    column = list(AUDIT_ARCH).index(machine)
    code = [(LOAD, 0, 0, ARCH), (JUMP_EQ, 1, 0, AUDIT_ARCH[machine]), KILL, (LOAD, 0, 0, NUMBER)]
    code += [(JUMP_GE, 0, 1, X32_BIT), _fail(errno.EPERM)]  # aarch64 has no such numbers

    calls = tomllib.loads(CALLS.read_text())

    def on(call: str, *block: Instruction, table: str = "inspected") -> None:
        """Run `block` on this call; it must end in a return."""
        code.extend([(JUMP_EQ, 0, len(block), calls[table][call][column]), *block])

    for call in calls["refused"]:
        on(call, _fail(errno.EPERM), table="refused")
    on("clone3", _fail(errno.ENOSYS))
    on("clone", *_unless(0, NAMESPACES, test=JUMP_SET))
    # Shared anonymous memory stays allocated when no process maps it any more.
    shared = (JUMP_SET, 0, 2, MAP_SHARED), (JUMP_SET, 0, 1, MAP_ANONYMOUS)
    on("mmap", _load(3), *shared, _fail(errno.EPERM), ALLOW)
    on("ioctl", *_unless(1, *TYPING))
    on("prctl", *_unless(0, *PRCTL_REFUSED))
    if not counted:
        # The second argument is the address of the new action; 0 only asks for the old one.
        anything = _load(1), (JUMP_EQ, 0, 3, 0), _load(1, HIGH), (JUMP_EQ, 0, 1, 0)
        on("sigaction", _load(0), (JUMP_EQ, 0, 4, SIGCHLD), *anything, ALLOW, _fail(0))
    if not compiling:
        on("flock", _fail(errno.EPERM))
        on("fcntl", *_unless(1, *FCNTL_REFUSED))
    code.append(ALLOW)
    return b"".join(struct.pack("<HBBI", *instruction) for instruction in code)


def _load(argument: int, word: int = 0) -> Instruction:
    return LOAD, 0, 0, ARGUMENTS + argument * ARGUMENT_BYTES + word


def _fail(error: int) -> Instruction:
    """Refuse the call with this error; 0 pretends that it succeeded."""
    return RETURN, 0, 0, 0x00050000 | error


def _unless(argument: int, *values: int, test: int = JUMP_EQ) -> tuple[Instruction, ...]:
    """Refuse these values of an argument, and allow all others."""
    *most, last = values
    tests = [(test, len(most) - number, 0, value) for number, value in enumerate(most)]
    return _load(argument), *tests, (test, 0, 1, last), _fail(errno.EPERM), ALLOW
