"""What one run may use, and what was seen of it. Facts only: verdicts are made elsewhere."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

# The kill limit lies above the verdict limit, so that a program at the limit is
# measured rather than cut, and a report shows by how much it was over.
KILL_FACTOR = 1.1
KILL_MARGIN_S = 0.25
WALL_FACTOR = 2.0
WALL_MARGIN_S = 3.0


class Stop(StrEnum):
    """Why a run was ended from outside."""

    CPU = "cpu"
    WALL = "wall"
    MEMORY = "memory"
    OUTPUT = "output"
    PROCESSES = "processes"


@dataclass(frozen=True, slots=True)
class RunLimits:
    """What one run may use, all of its processes together.

    time_limit_s: CPU seconds; memory_mib: peak resident memory; output_mib:
    standard output and standard error together; processes: alive at once.
    """

    time_limit_s: float
    memory_mib: int
    output_mib: int
    processes: int = 128

    @property
    def kill_cpu_s(self) -> float:
        """CPU seconds at which the run is ended."""
        return KILL_FACTOR * self.time_limit_s + KILL_MARGIN_S

    @property
    def kill_wall_s(self) -> float:
        """Wall seconds at which a sleeper is ended; waiting for a processor does not count."""
        return WALL_FACTOR * self.time_limit_s + WALL_MARGIN_S

    @property
    def output_bytes(self) -> int:
        """The output limit in bytes."""
        return self.output_mib << 20


@dataclass(frozen=True, slots=True)
class Facts:
    """What was seen of one run.

    exit_status, signal: of the program itself; exactly one of them is None.
    cpu_s: user and system seconds of the whole process tree; wall_s: from launch
    to end; memory_mib: the largest sum of resident memory seen over the tree;
    output_bytes: what it wrote to standard output and standard error;
    stopped: why it was ended, None if it ended by itself;
    stderr: the first few KiB of standard error.
    """

    exit_status: int | None
    signal: int | None
    cpu_s: float
    wall_s: float
    memory_mib: float
    output_bytes: int
    stopped: Stop | None
    stderr: bytes = b""
