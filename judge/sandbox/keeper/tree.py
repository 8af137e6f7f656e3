"""All processes of a program: what they used, and how they are killed."""

from __future__ import annotations

import contextlib
import os
import resource
import signal
import time
from collections.abc import Mapping

from judge.sandbox.keeper.cgroup import Cgroup
from judge.sandbox.keeper.memory import Memory
from judge.sandbox.keeper.proc import descendants, look_at, read

REAP_TIMEOUT_S = 10.0


class Tree:
    """All processes below the keeper, which are those of the one program it runs.

    cpu_s: the larger of two counts. The kernel's accounting misses children that were reaped
    automatically. The sum over all processes at their last sample misses what was used after it.
    A control group misses nothing; where there is one, no process is sampled.
    memory_mib: the largest sample; largest_mib: of one reaped process, exact to the page.
    """

    def __init__(self, scratch: Mapping[str, int], cgroup: Cgroup) -> None:
        self._memory = Memory(scratch)
        self._cgroup = cgroup
        self.cpu_s = 0.0
        self.memory_mib = 0.0
        self.largest_mib = 0.0
        self.processes = 0
        self.status: dict[int, int] = {}
        self._reaped_s = 0.0
        self._own_began_s = time.process_time()
        self._seen_s: dict[tuple[int, str], float] = {}

    def sample(self, memory_limit_mib: float) -> None:
        """Sample what lives now: the control group if there is one, else each process."""
        if self._cgroup.there:
            self.processes = self._cgroup.processes()
            memory_mib = self._cgroup.memory_mib()
        else:
            live = [process for process in map(look_at, descendants()) if process is not None]
            self.processes = len(live)
            memory_mib = self._memory.used_mib(live, memory_limit_mib)
            accounted_s = self._reaped_s + sum(each.own_s + each.waited_s for each in live)
            self._seen_s.update({process.identity: process.own_s for process in live})
            self.cpu_s = max(self.cpu_s, accounted_s, sum(self._seen_s.values()))
        self.memory_mib = max(self.memory_mib, memory_mib)
        self.cpu_s = max(self.cpu_s, self._counted_s())

    def starved_s(self) -> float:
        """Return how long a live process was ready to run while others had the processors.

        The keeper's own time is left out: the program caused that work.
        """
        stats = [read(f"/proc/{pid}/schedstat").split() for pid in descendants()]
        ready_s = max((int(stat[1]) / 1e9 for stat in stats if stat), default=0.0)
        return ready_s - self._own_s()

    def end(self) -> bool:
        """Kill and reap everything; return whether no process is left, as some die slowly."""
        began = time.monotonic()
        while self._reap() and (waited_s := time.monotonic() - began) < REAP_TIMEOUT_S:
            # Stop them first: a stopped process cannot fork while the others are signalled.
            for number in (signal.SIGSTOP, signal.SIGKILL):
                for pid in descendants():
                    with contextlib.suppress(ProcessLookupError):
                        os.kill(pid, number)
            time.sleep(min(0.0002 + waited_s / 50, 0.02))
        self.cpu_s = max(self.cpu_s, self._reaped_s, self._counted_s())
        return not self._reap()

    def peak_mib(self) -> float:
        """Return the peak memory. A small program shows the keeper's peak; then samples decide."""
        keeper_mib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        if self.largest_mib <= keeper_mib and self.memory_mib > 0:
            return self.memory_mib
        return max(self.largest_mib, self.memory_mib)

    def _counted_s(self) -> float:
        """Return what the control group counted, without the keeper itself, which is in it."""
        return self._cgroup.cpu_s() - self._own_s() if self._cgroup.there else 0.0

    def _own_s(self) -> float:
        return time.process_time() - self._own_began_s

    def _reap(self) -> bool:
        """Reap what has ended; return whether anything still lives."""
        with contextlib.suppress(ChildProcessError):
            while (ended := os.wait4(-1, os.WNOHANG))[0]:
                pid, self.status[pid], usage = ended
                self._reaped_s += usage.ru_utime + usage.ru_stime
                self.largest_mib = max(self.largest_mib, usage.ru_maxrss / 1024)
            return True
        return False
