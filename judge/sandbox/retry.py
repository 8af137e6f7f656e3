"""When a run is repeated: the rules for single runs, each for a fault of the machine.

`judge.pool` repeats a task of a worker that broke, and a run over the declared limit if this
machine turns out to be slower than the one that set it.

A program never gets a repeat by what it prints. What disturbs a measurement only ever adds
to it, so a run that was too slow beside others says little, and one alone says more.
"""

from __future__ import annotations

from signal import SIGKILL

from judge.sandbox.facts import Facts, RunLimits

TRIES = 2  # of a run that could not be made, or that something else killed
KILLED = 128 + SIGKILL  # how a wall, or a shell, passes SIGKILL on


def killed_by_another(facts: Facts) -> bool:
    """Tell whether a SIGKILL ended the run that the keeper did not send.

    The kernel, out of memory, may have sent it, or a person.
    """
    return facts.stopped is None and (facts.signal == SIGKILL or facts.exit_status == KILLED)


def repeat_alone(cpu_s: float, limits: RunLimits, *, beside_others: bool) -> bool:
    """Tell whether a run over the time limit is repeated with no run beside it, which decides.

    It is if other runs went on beside it, or if it came to its own end: then it was not over
    the limit by much.
    """
    return beside_others or limits.time_limit_s < cpu_s <= limits.kill_cpu_s
