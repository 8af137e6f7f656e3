"""The processors of this machine."""

from __future__ import annotations

import os
from pathlib import Path

TOPOLOGY = Path("/sys/devices/system/cpu")


def processors() -> int:
    """Return how many processors this process may use."""
    return len(os.sched_getaffinity(0))


def cores(topology: Path = TOPOLOGY) -> int:
    """Return how many physical cores this process may use, at least 1.

    Two hardware threads of one core slow each other down, so programs whose time counts run
    one on each core. Where the kernel does not tell which processors share a core, two do.
    """
    allowed = os.sched_getaffinity(0)
    siblings = set()
    for processor in allowed:
        try:
            path = topology / f"cpu{processor}" / "topology" / "thread_siblings_list"
            siblings.add(path.read_text().strip())
        except OSError:
            return max(1, len(allowed) // 2)
    return len(siblings)
