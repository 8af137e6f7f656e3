"""Decides the verdict of a run from its facts, by a pure function."""

from __future__ import annotations

import math
import signal
from dataclasses import dataclass

from judge.compare import Mismatch
from judge.problem.verdict import Verdict
from judge.sandbox.facts import Facts, RunLimits, Stop

# What the usual signals are called, and what they mean.
SIGNALS: dict[int, tuple[str, str]] = {
    signal.SIGSEGV: (
        "segmentation fault",
        "it read or wrote memory that is not its own "
        "(an index out of range, or too deep a recursion?)",
    ),
    signal.SIGBUS: ("bus error", "it read or wrote memory that is not there"),
    signal.SIGFPE: ("arithmetic error", "an integer was divided by zero"),
    signal.SIGABRT: ("aborted", "it ended itself, as a failed check does"),
    signal.SIGILL: ("illegal instruction", "did a function end without its return?"),
}


@dataclass(frozen=True, slots=True)
class Judgement:
    """A verdict and a short text with its reason; empty for AC."""

    verdict: Verdict
    message: str = ""


def decide(
    facts: Facts, limits: RunLimits, mismatch: Mismatch | None, reason: str = ""
) -> Judgement:
    """Return the judgement of one run. Pure.

    mismatch: the first difference between output and answer. reason: the program's own message
    about its crash. An exceeded limit decides first, then how the program ended, then its
    output: a stopped program has no exit status of its own, and the output of a crashed
    program means nothing.
    """
    if facts.stopped is Stop.PROCESSES:
        return Judgement(Verdict.RTE, "too many processes at once")
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
    if facts.stopped is Stop.ELAPSED:
        return Judgement(
            Verdict.TLE,
            f"slept or waited: {facts.cpu_s:.2f} s of CPU time in {facts.elapsed_s:.1f} s",
        )
    if facts.signal is not None:
        return Judgement(Verdict.RTE, _signal_said(facts.signal, reason))
    if facts.exit_status != 0:
        return Judgement(Verdict.RTE, _with_reason(_exit_name(facts), reason))
    if mismatch is not None:
        return Judgement(Verdict.WA, str(mismatch))
    return Judgement(Verdict.AC)


def _with_reason(what: str, reason: str) -> str:
    return f"{what}: {reason}" if reason else what


def _exit_name(facts: Facts) -> str:
    """Name an exit status; shells and walls report a signal as 128 plus its number."""
    status = facts.exit_status or 0
    if status - 128 in signal.valid_signals():
        return f"exit status {status} (its own, or {_signal_name(status - 128)})"
    return f"exit status {status}"


def _signal_said(number: int, reason: str) -> str:
    """Say in plain words how a signal ended the program; an abort's own reason is better."""
    if number not in SIGNALS:
        return _with_reason(_signal_name(number), reason)
    what, meaning = SIGNALS[number]
    what = f"{what} ({signal.Signals(number).name})"
    if not reason:
        return f"{what}: {meaning}"
    return (
        f"{what}: {reason}" if number == signal.SIGABRT else f"{what}: {meaning}; it said: {reason}"
    )


def _signal_name(number: int) -> str:
    try:
        name = signal.Signals(number)
    except ValueError:
        return f"ended by signal {number}"
    return f"ended by {name.name} ({signal.strsignal(number)})"
