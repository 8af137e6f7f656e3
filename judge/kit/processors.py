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

    Two hardware threads of one core slow each other down, so only one measured program runs on
    each core. If the kernel does not say which processors share a core, two are assumed to.
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
