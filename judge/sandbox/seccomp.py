"""The system-call filter of the wall, assembled here without a library.

Refused calls fail with EPERM; those whose arguments the filter cannot see fail with ENOSYS, so
that libraries use older ones. Children of a process that ignores SIGCHLD are not charged to it.
So unless a control group counts CPU time, no program may ignore it: the call seems to succeed.
Source: Linux, Documentation/userspace-api/seccomp_filter.rst; linux/filter.h.
"""

from __future__ import annotations

import errno
import struct

AUDIT_ARCH = {"x86_64": 0xC000003E, "aarch64": 0xC00000B7}

# the number of each call on x86_64 and on aarch64
REFUSED: dict[str, tuple[int, int]] = {
    "socket": (41, 198),
    "sendmsg": (46, 211),  # descriptors in transit stay open in the kernel
    "sendmmsg": (307, 269),
    "setsockopt": (54, 208),  # could enlarge a socket's buffer
    "shmget": (29, 194),
    "semget": (64, 190),
    "msgget": (68, 186),
    "syslog": (103, 116),
    "ptrace": (101, 117),
    "personality": (135, 92),
    "vmsplice": (278, 75),
    "add_key": (248, 217),
    "request_key": (249, 218),
    "keyctl": (250, 219),
    "unshare": (272, 97),
    "perf_event_open": (298, 241),
    "fanotify_init": (300, 262),
    "inotify_init": (253, 26),  # its queues hold kernel memory; aarch64 has only the next one
    "inotify_init1": (294, 26),
    "process_vm_readv": (310, 270),
    "process_vm_writev": (311, 271),
    "kcmp": (312, 272),
    "memfd_create": (319, 279),
    "bpf": (321, 280),
    "userfaultfd": (323, 282),
    "io_uring_setup": (425, 425),
    "pidfd_getfd": (438, 438),
    "memfd_secret": (447, 447),
    "io_setup": (206, 0),  # takes a share of what the whole machine has
    "mq_open": (240, 180),
    "setpriority": (141, 140),  # a program that gives way dies slowly
    "sched_setscheduler": (144, 119),
    "sched_setattr": (314, 274),
    "ioprio_set": (251, 30),
}
CLONE, IOCTL, MMAP = (56, 220), (16, 29), (9, 222)
CLONE3 = (435, 435)  # its arguments are in memory
SIGACTION, FCNTL, FLOCK, PRCTL = (13, 134), (72, 25), (73, 32), (157, 167)
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

    def on(call: tuple[int, int], *block: Instruction) -> None:
        """Run `block` on this call; it must end in a return."""
        code.extend([(JUMP_EQ, 0, len(block), call[column]), *block])

    for call in REFUSED.values():
        on(call, _fail(errno.EPERM))
    on(CLONE3, _fail(errno.ENOSYS))
    on(CLONE, *_unless(0, NAMESPACES, test=JUMP_SET))
    # Shared anonymous memory stays allocated when no process maps it any more.
    shared = (JUMP_SET, 0, 2, MAP_SHARED), (JUMP_SET, 0, 1, MAP_ANONYMOUS)
    on(MMAP, _load(3), *shared, _fail(errno.EPERM), ALLOW)
    on(IOCTL, *_unless(1, *TYPING))
    on(PRCTL, *_unless(0, *PRCTL_REFUSED))
    if not counted:
        # The second argument is the address of the new action; 0 only asks for the old one.
        anything = _load(1), (JUMP_EQ, 0, 3, 0), _load(1, HIGH), (JUMP_EQ, 0, 1, 0)
        on(SIGACTION, _load(0), (JUMP_EQ, 0, 4, SIGCHLD), *anything, ALLOW, _fail(0))
    if not compiling:
        on(FLOCK, _fail(errno.EPERM))
        on(FCNTL, *_unless(1, *FCNTL_REFUSED))
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
