"""The limits of one run and the facts about it. Verdicts are decided elsewhere."""

from __future__ import annotations

from dataclasses import dataclass

from judge.sandbox.keeper.protocol import Facts, Stop

__all__ = ["Facts", "RunLimits", "Stop"]

# The kill limit lies above the verdict limit, so that a program slightly over the limit
# runs to its end, and the report shows by how much it was over.
KILL_FACTOR = 1.1
KILL_MARGIN_S = 0.25
ELAPSED_FACTOR = 2.0
ELAPSED_MARGIN_S = 3.0


@dataclass(frozen=True, slots=True)
class RunLimits:
    """What all processes of one run may use together.

    time_limit_s: CPU seconds; memory_mib: peak resident memory; output_mib: standard output
    and standard error together; processes: alive at once (without control groups, which
    count the kernel's memory, at most UNLISTED_PROCESSES); elapsed_s: elapsed seconds,
    None for what a program needs that is kept waiting.
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
