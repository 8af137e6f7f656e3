"""When a run is repeated: once, and only for what the machine did, with evidence.

How a program ended is no evidence: one that fails at random could buy itself another try. So
a run that was killed is repeated only if the kernel ran out of memory meanwhile.
"""

from __future__ import annotations

from pathlib import Path
from signal import SIGKILL

from judge.sandbox.facts import Facts

KILLED = 128 + SIGKILL  # how a wall, or a shell, passes SIGKILL on
VMSTAT = Path("/proc/vmstat")


def killed_by_another(facts: Facts) -> bool:
    """Tell whether a SIGKILL that the keeper did not send ended the run."""
    return facts.stopped is None and (facts.signal == SIGKILL or facts.exit_status == KILLED)


def out_of_memory_kills(vmstat: Path = VMSTAT) -> int:
    """Return how many processes the kernel has killed for want of memory, 0 if it is unknown."""
    lines = vmstat.read_text().splitlines() if vmstat.exists() else []
    return next((int(line.split()[1]) for line in lines if line.startswith("oom_kill ")), 0)
