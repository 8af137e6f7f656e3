"""The C library, for calls that Python does not offer."""

from __future__ import annotations

import ctypes
import platform
from collections.abc import Mapping

LIBC = ctypes.CDLL(None, use_errno=True)


def system_call(numbers: Mapping[str, int], *arguments: int | bytes) -> int:
    """Make a system call by its number on this machine; -1 if it fails or no number is known."""
    number = numbers.get(platform.machine())
    return -1 if number is None else int(LIBC.syscall(number, *arguments))
