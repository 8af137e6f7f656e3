"""All processes of a program: what they used, and how they are ended."""

from __future__ import annotations

import contextlib
import os
import resource
import signal
import time
from collections.abc import Mapping

from judge.keeper.clock import Clock
from judge.keeper.group import Group
from judge.keeper.proc import (
    Process,
    children,
    descendants,
    held_mib,
    look_at,
    proportional_mib,
    read,
    tables_mib,
)

REAP_TIMEOUT_S = 10.0
ORDERLY_END_S = 0.003  # after that, what is left is not ending by itself
WALL_PROCESSES = 2  # one outside, and the first within; their memory is not the program's
SHARED_EVERY = 10  # looks


class Tree:
    """All processes below the keeper, which are those of the one program it runs.

    cpu_s: the largest of four counts. Accounting (reaped processes, and what live
    ones and their reaped children used) misses children reaped automatically; adding up
    every process at its last sample misses what happened after that; the clock and
    the group miss nothing, where there is one.

    scratch: the sizes in bytes of the wall's memory file systems by their places; what
    they hold is memory of the program's, and no process shows it.
    """

    def __init__(self, scratch: Mapping[str, int]) -> None:
        self._scratch = scratch
        self.clock: Clock | None = None
        self.group: Group | None = None
        self.cpu_s = 0.0
        self.memory_mib = 0.0
        self.processes = 0
        self._looks = 0
        self.largest_mib = 0.0  # of one reaped process, exact to the page
        self.status: dict[int, int] = {}
        self._reaped_s = 0.0
        self._seen_s: dict[tuple[int, str], float] = {}

    def sample(self, memory_limit_mib: float) -> None:
        """Look at every live process once."""
        live = [process for process in map(look_at, descendants()) if process is not None]
        accounted_s = self._reaped_s + sum(process.own_s + process.waited_s for process in live)
        self._seen_s.update({(process.pid, process.started): process.own_s for process in live})
        self.processes = len(live)
        self.memory_mib = max(self.memory_mib, self._memory_now_mib(live, memory_limit_mib))
        self.cpu_s = max(self.cpu_s, accounted_s, sum(self._seen_s.values()), self._counted_s())

    def _memory_now_mib(self, live: list[Process], limit_mib: float) -> float:
        """Return the memory in use; what several processes share counts once.

        To find that out is slow: now and then, and whenever it decides. Otherwise it is
        what there is at least.
        """
        self._looks += 1
        held = next((mib for process in live if (mib := held_mib(process, self._scratch))), 0.0)
        held += sum(map(tables_mib, live))
        own = (self._scratch and live[WALL_PROCESSES:]) or live
        most_mib = sum(process.resident_mib for process in own) + held
        if len(own) < 2:
            return most_mib
        if most_mib > limit_mib or self._looks % SHARED_EVERY == 1:
            return sum(map(proportional_mib, own)) + held
        return max(process.resident_mib for process in own) + held

    def starved_s(self) -> float:
        """Return how long a live process was ready to run while others had the processors."""
        stats = [read(f"/proc/{pid}/schedstat").split() for pid in descendants()]
        return max((int(stat[1]) / 1e9 for stat in stats if stat), default=0.0)

    def end(self) -> None:
        """Kill and reap everything; when it returns, no child is left. Raises TimeoutError."""
        began = time.monotonic()
        if self.group is not None:
            self.group.kill()
        while self._reap():
            waited_s = time.monotonic() - began
            if waited_s > REAP_TIMEOUT_S:
                raise TimeoutError("processes of the program cannot be killed")
            if waited_s > ORDERLY_END_S:
                # Freeze first: what is stopped cannot fork away from the list.
                signal_all(descendants(), signal.SIGSTOP)
                signal_all(descendants(), signal.SIGKILL)
            else:
                # Behind a wall this ends all, in two steps: who held the first process of the
                # namespace, and then that, with which the namespace dies.
                signal_all(children(os.getpid()), signal.SIGKILL)
            time.sleep(0.0002)
        self.cpu_s = max(self.cpu_s, self._reaped_s, self._counted_s())

    def _counted_s(self) -> float:
        counters = [counter for counter in (self.clock, self.group) if counter is not None]
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
    """Return the peak memory, leaving out what a small program only inherited from the keeper."""
    keeper_mib = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    if tree.largest_mib <= keeper_mib and tree.memory_mib > 0:
        return tree.memory_mib
    return max(tree.largest_mib, tree.memory_mib)
