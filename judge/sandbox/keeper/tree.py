"""All processes of a program: what they used, and how they are killed."""

from __future__ import annotations

import contextlib
import os
import resource
import signal
import time
from collections.abc import Mapping

from judge.sandbox.keeper.cgroup import Cgroup
from judge.sandbox.keeper.clock import Clock
from judge.sandbox.keeper.memory import Memory
from judge.sandbox.keeper.proc import children, descendants, look_at, read

REAP_TIMEOUT_S = 10.0
ORDERLY_END_S = 0.003  # processes left after that do not end by themselves


class Tree:
    """All processes below the keeper, which belong to the one program it runs.

    cpu_s: the largest of four counts. The kernel's accounting (of reaped processes, and of
    live ones with their reaped children) misses children that were reaped automatically. The
    sum over all processes at their last sample misses what happened later. The clock and the
    control group miss nothing, but they do not exist on every machine.

    scratch: see `memory.Memory`.
    """

    def __init__(self, scratch: Mapping[str, int]) -> None:
        self._memory = Memory(scratch)
        self.clock: Clock | None = None
        self.cgroup: Cgroup | None = None
        self.cpu_s = 0.0
        self.memory_mib = 0.0
        self.processes = 0
        self.largest_mib = 0.0  # of one reaped process, exact to the page
        self.status: dict[int, int] = {}
        self._reaped_s = 0.0
        self._own_began_s = time.process_time()
        self._seen_s: dict[tuple[int, str], float] = {}

    def sample(self, memory_limit_mib: float) -> None:
        """Sample every live process once."""
        live = [process for process in map(look_at, descendants()) if process is not None]
        accounted_s = self._reaped_s + sum(process.own_s + process.waited_s for process in live)
        self._seen_s.update({process.identity: process.own_s for process in live})
        self.processes = len(live)
        self.memory_mib = max(self.memory_mib, self._memory.used_mib(live, memory_limit_mib))
        self.cpu_s = max(self.cpu_s, accounted_s, sum(self._seen_s.values()), self._counted_s())

    def starved_s(self) -> float:
        """Return for how many seconds a live process waited for a processor; of all, the longest.

        The keeper's own CPU time is subtracted, because the program caused that work.
        """
        stats = [read(f"/proc/{pid}/schedstat").split() for pid in descendants()]
        ready_s = max((int(stat[1]) / 1e9 for stat in stats if stat), default=0.0)
        return ready_s - (time.process_time() - self._own_began_s)

    def end(self) -> None:
        """Kill and reap everything; when it returns, no child is left. Raises TimeoutError."""
        began = time.monotonic()
        if self.cgroup is not None:
            self.cgroup.kill()
        while self._reap():
            waited_s = time.monotonic() - began
            if waited_s > REAP_TIMEOUT_S:
                raise TimeoutError("processes of the program cannot be killed")
            if waited_s > ORDERLY_END_S:
                # Stop them first: a stopped process cannot fork while the others are signalled.
                signal_all(descendants(), signal.SIGSTOP)
                signal_all(descendants(), signal.SIGKILL)
            else:
                # Behind a wall this ends everything in two steps: bubblewrap's outer process,
                # then the first process of the namespace, and the kernel ends the rest.
                signal_all(children(os.getpid()), signal.SIGKILL)
            time.sleep(0.0002)
        self.cpu_s = max(self.cpu_s, self._reaped_s, self._counted_s())

    def _counted_s(self) -> float:
        counters = [counter for counter in (self.clock, self.cgroup) if counter is not None]
        return max((counter.cpu_s() for counter in counters), default=0.0)

    def _reap(self) -> bool:
        """Reap what has ended; return whether anything still lives."""
        while True:
            try:
                pid, status, usage = os.wait4(-1, os.WNOHANG)
            except ChildProcessError:
                return False
            if pid == 0:
                return True
            self.status[pid] = status
            self._reaped_s += usage.ru_utime + usage.ru_stime
            self.largest_mib = max(self.largest_mib, usage.ru_maxrss / 1024)


def signal_all(pids: list[int], number: int) -> None:
    """Send a signal to each process that is still there."""
    for pid in pids:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, number)


def peak_mib(tree: Tree) -> float:
    """Return the peak memory. A small program shows the keeper's peak; then samples decide."""
    keeper_mib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    if tree.largest_mib <= keeper_mib and tree.memory_mib > 0:
        return tree.memory_mib
    return max(tree.largest_mib, tree.memory_mib)
