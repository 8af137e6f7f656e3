"""The pure function from the facts of a run to its verdict."""

from __future__ import annotations

import math
import signal
from dataclasses import dataclass

from judge.compare import Mismatch
from judge.kit.text import printable_lines
from judge.problem.verdict import Verdict
from judge.sandbox.facts import Facts, RunLimits, Stop


@dataclass(frozen=True, slots=True)
class Judgement:
    """A verdict and one short text saying why; empty for AC."""

    verdict: Verdict
    message: str = ""


def decide(facts: Facts, limits: RunLimits, mismatch: Mismatch | None) -> Judgement:
    """Return the judgement of one run. Pure.

    A limit exceeded outweighs how the program ended, which outweighs what it
    printed: a program ended from outside has no exit status of its own, and the
    output of one that crashed says nothing.
    """
    if facts.stopped is Stop.PROCESSES:
        return Judgement(Verdict.RTE, f"more than {limits.processes} processes at once")
    if facts.stopped is Stop.MEMORY or facts.memory_mib > limits.memory_mib:
        return Judgement(
            Verdict.MLE,
            f"{math.ceil(facts.memory_mib)} MiB of memory, limit {limits.memory_mib} MiB",
        )
    if facts.stopped is Stop.OUTPUT or facts.output_bytes > limits.output_bytes:
        return Judgement(
            Verdict.OLE, f"more than {limits.output_mib} MiB of output and standard error"
        )
    if facts.stopped is Stop.CPU or facts.cpu_s > limits.time_limit_s:
        return Judgement(
            Verdict.TLE, f"{facts.cpu_s:.2f} s of CPU time, limit {limits.time_limit_s:.2f} s"
        )
    if facts.stopped is Stop.WALL:
        return Judgement(
            Verdict.TLE,
            f"slept or waited: {facts.cpu_s:.2f} s of CPU time in {facts.wall_s:.1f} s",
        )
    if facts.signal is not None:
        return Judgement(Verdict.RTE, _with_stderr(_signal_name(facts.signal), facts.stderr))
    if facts.exit_status != 0:
        return Judgement(Verdict.RTE, _with_stderr(_exit_name(facts), facts.stderr))
    if mismatch is not None:
        return Judgement(Verdict.WA, str(mismatch))
    return Judgement(Verdict.AC)


def _exit_name(facts: Facts) -> str:
    """Name an exit status; a shell, and a wall, pass a signal on as 128 and its number."""
    status = facts.exit_status or 0
    if status - 128 in signal.valid_signals():
        return f"exit status {status} (its own, or {_signal_name(status - 128)})"
    return f"exit status {status}"


def _signal_name(number: int) -> str:
    try:
        name = signal.Signals(number)
    except ValueError:
        return f"ended by signal {number}"
    return f"ended by {name.name} ({signal.strsignal(number)})"


def _with_stderr(what: str, stderr: bytes) -> str:
    """Add the line of the standard error that says why: in most languages the last one."""
    lines = printable_lines(stderr, lines=1000, width=120).splitlines()
    lines += [line for line in lines if line.startswith("Exception in thread")][:1]  # Java
    return f"{what}: {lines[-1]}" if lines else what
