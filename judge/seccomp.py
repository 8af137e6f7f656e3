"""The system-call filter of the wall, assembled by hand: no library, no surprise.

What a contest program never needs and what widens the attack: mounting, new
namespaces, tracing others, kernel keys, BPF, io_uring, memory that no process shows,
sockets, the kernel's log, and typing into the terminal. Refused calls fail with EPERM, clone3 with
ENOSYS so that libraries fall back to clone, whose flags can be seen.
Source: Linux, Documentation/userspace-api/seccomp_filter.rst; linux/filter.h.
"""

from __future__ import annotations

import errno
import struct

AUDIT_ARCH = {"x86_64": 0xC000003E, "aarch64": 0xC00000B7}

# number on x86_64, on aarch64; -1: it does not exist there
REFUSED: dict[str, tuple[int, int]] = {
    "socket": (41, 198),
    "shmget": (29, 194),
    "semget": (64, 190),
    "msgget": (68, 186),
    "syslog": (103, 116),
    "ptrace": (101, 117),
    "personality": (135, 92),
    "vmsplice": (278, 75),
    "pivot_root": (155, 41),
    "chroot": (161, 51),
    "acct": (163, 89),
    "mount": (165, 40),
    "umount2": (166, 39),
    "swapon": (167, 224),
    "swapoff": (168, 225),
    "reboot": (169, 142),
    "sethostname": (170, 161),
    "init_module": (175, 105),
    "delete_module": (176, 106),
    "add_key": (248, 217),
    "request_key": (249, 218),
    "keyctl": (250, 219),
    "unshare": (272, 97),
    "perf_event_open": (298, 241),
    "fanotify_init": (300, 262),
    "open_by_handle_at": (304, 265),
    "setns": (308, 268),
    "process_vm_readv": (310, 270),
    "process_vm_writev": (311, 271),
    "kcmp": (312, 272),
    "finit_module": (313, 273),
    "memfd_create": (319, 279),
    "kexec_file_load": (320, 294),
    "bpf": (321, 280),
    "userfaultfd": (323, 282),
    "io_uring_setup": (425, 425),
    "io_uring_enter": (426, 426),
    "io_uring_register": (427, 427),
    "open_tree": (428, 428),
    "move_mount": (429, 429),
    "fsopen": (430, 430),
    "fsmount": (432, 432),
    "pidfd_getfd": (438, 438),
    "mount_setattr": (442, 442),
    "memfd_secret": (447, 447),
}
CLONE, CLONE3, IOCTL, MMAP = (56, 220), (435, 435), (16, 29), (9, 222)
NAMESPACES = 0x7E020000  # CLONE_NEWNS, NEWCGROUP, NEWUTS, NEWIPC, NEWUSER, NEWPID, NEWNET
TIOCSTI, TIOCLINUX = 0x5412, 0x541C
MAP_SHARED, MAP_ANONYMOUS = 0x01, 0x20
X32_BIT = 0x40000000

LOAD, JUMP_EQ, JUMP_GE, JUMP_SET, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
ALLOW, KILL, ERRNO = 0x7FFF0000, 0x80000000, 0x00050000
NUMBER, ARCH, ARG0, ARG1, ARG3 = 0, 4, 16, 24, 40  # offsets in struct seccomp_data, low words


def filter_program(machine: str) -> bytes:
    """Return the filter for a machine (`x86_64`, `aarch64`). Raises KeyError for another."""
    column = list(AUDIT_ARCH).index(machine) if machine in AUDIT_ARCH else None
    if column is None:
        raise KeyError(f"no system-call filter for {machine}")
    refuse, absent = ERRNO | errno.EPERM, ERRNO | errno.ENOSYS
    code = [
        (LOAD, 0, 0, ARCH),
        (JUMP_EQ, 1, 0, AUDIT_ARCH[machine]),
        (RETURN, 0, 0, KILL),
        (LOAD, 0, 0, NUMBER),
    ]
    if machine == "x86_64":
        code += [(JUMP_GE, 0, 1, X32_BIT), (RETURN, 0, 0, refuse)]
    for numbers in REFUSED.values():
        code += [(JUMP_EQ, 0, 1, numbers[column]), (RETURN, 0, 0, refuse)]
    code += [(JUMP_EQ, 0, 1, CLONE3[column]), (RETURN, 0, 0, absent)]
    code += [
        (JUMP_EQ, 0, 4, CLONE[column]),
        (LOAD, 0, 0, ARG0),
        (JUMP_SET, 0, 1, NAMESPACES),
        (RETURN, 0, 0, refuse),
        (RETURN, 0, 0, ALLOW),
    ]
    # What is shared and has no name stays when nothing of it is mapped any more.
    code += [
        (JUMP_EQ, 0, 5, MMAP[column]),
        (LOAD, 0, 0, ARG3),
        (JUMP_SET, 0, 2, MAP_SHARED),
        (JUMP_SET, 0, 1, MAP_ANONYMOUS),
        (RETURN, 0, 0, refuse),
        (RETURN, 0, 0, ALLOW),
    ]
    code += [
        (JUMP_EQ, 0, 4, IOCTL[column]),
        (LOAD, 0, 0, ARG1),
        (JUMP_EQ, 1, 0, TIOCSTI),
        (JUMP_EQ, 0, 1, TIOCLINUX),
        (RETURN, 0, 0, refuse),
        (RETURN, 0, 0, ALLOW),
    ]
    return b"".join(struct.pack("<HBBI", *instruction) for instruction in code)
