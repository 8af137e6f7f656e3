"""The limits of one run and the facts about it. Verdicts are decided elsewhere.

They are named tuples because the module `dataclasses` would make the keeper several MiB larger,
and with it the smallest peak memory that can be measured.
"""

from __future__ import annotations

from enum import StrEnum
from typing import NamedTuple

# The kill limit lies above the verdict limit, so that a program slightly over the limit
# runs to its end, and the report shows by how much it was over.
KILL_FACTOR, KILL_MARGIN_S = 1.1, 0.25
ELAPSED_FACTOR, ELAPSED_MARGIN_S = 2.0, 3.0
STARVED_AT_MOST_S = 60.0  # how long a run that waits for a processor may take beyond that
UNLISTED_PROCESSES = 32  # each may hold memory of the kernel that only a control group counts


class RunLimits(NamedTuple):
    """What all processes of one run may use together.

    time_limit_s: CPU seconds; memory_mib: peak memory; output_mib: standard output and
    standard error together; processes: alive at once (at most UNLISTED_PROCESSES without control
    groups); elapsed_s: elapsed seconds, None for what a program needs that is kept waiting.
    """

    time_limit_s: float
    memory_mib: int
    output_mib: int
    processes: int = 128
    elapsed_s: float | None = None

    @property
    def kill_cpu_s(self) -> float:
        """The CPU seconds after which the run is stopped."""
        return KILL_FACTOR * self.time_limit_s + KILL_MARGIN_S

    @property
    def kill_elapsed_s(self) -> float:
        """Elapsed seconds at which a sleeper is ended; waiting for a processor does not count."""
        return self.elapsed_s or ELAPSED_FACTOR * self.time_limit_s + ELAPSED_MARGIN_S

    @property
    def output_bytes(self) -> int:
        """The output limit in bytes."""
        return self.output_mib << 20


class Stop(StrEnum):
    """The limit for which the keeper stopped a run."""

    CPU = "cpu"
    ELAPSED = "elapsed"
    MEMORY = "memory"
    OUTPUT = "output"
    PROCESSES = "processes"


class Facts(NamedTuple):
    """The facts about one run, of all its processes.

    exit_status, signal: of the program itself; exactly one of them is None. output_bytes:
    standard error included. stopped: None if it ended by itself. stderr: its first and last KiB.
    all_ended: whether no process is left, as some die slowly.
    """

    exit_status: int | None
    signal: int | None
    cpu_s: float
    elapsed_s: float
    memory_mib: float
    output_bytes: int
    stopped: Stop | None
    stderr: bytes = b""
    all_ended: bool = True
