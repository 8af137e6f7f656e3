"""The rules for repeating a run. Each answers a fault of the machine, not of the program.

`judge.pool` also repeats a task if its worker broke, and a run over the declared limit if this
machine turns out to be slower than the one that set the limit.

What a program prints never causes a repeat. Disturbances only add time, so a run that was too
slow while others went on is repeated alone.
"""

from __future__ import annotations

from signal import SIGKILL

from judge.sandbox.facts import Facts, RunLimits

TRIES = 2  # if a run could not be made, or was killed by something else than the keeper
KILLED = 128 + SIGKILL  # how a wall or a shell reports SIGKILL


def killed_by_another(facts: Facts) -> bool:
    """Tell whether the run was ended by a SIGKILL that the keeper did not send.

    The kernel sends one when it is out of memory; a person may have sent it, too.
    """
    return facts.stopped is None and (facts.signal == SIGKILL or facts.exit_status == KILLED)


def repeat_alone(cpu_s: float, limits: RunLimits, *, beside_others: bool) -> bool:
    """Tell whether a run over the time limit is repeated alone. The repeated run then decides.

    It is repeated if other runs went on at the same time, or if it was over the limit by so
    little that it was not stopped.
    """
    return beside_others or limits.time_limit_s < cpu_s <= limits.kill_cpu_s
