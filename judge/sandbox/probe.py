"""Finds a wall that works on this machine, by a trial run."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path

from judge.kit.text import printable_lines
from judge.sandbox.facts import RunLimits
from judge.sandbox.sandbox import Command, Sandbox, SandboxError
from judge.sandbox.wall import candidates

TRIAL = Command(("/bin/sh", "-c", ":"))
TRIAL_LIMITS = RunLimits(time_limit_s=2.0, memory_mib=64, output_mib=1)


class NoWallError(SandboxError):
    """No wall works on this machine; the message says why."""


def walled_sandbox(
    keepers: int = 1, hidden: tuple[Path, ...] = (), *, without_wall: bool = False
) -> Sandbox:
    """Return a sandbox whose wall works, after one trial run in it: about 40 ms.

    keepers: as of `Sandbox`; hidden: as of `Wall`; without_wall: if none works, return a sandbox
    without one. Otherwise raises NoWallError.
    """
    why = "no bwrap is installed"
    for wall in candidates(hidden):
        try:
            with ExitStack() as unless_it_works:
                sandbox = unless_it_works.enter_context(Sandbox(wall, keepers))
                facts = sandbox.run(TRIAL, TRIAL_LIMITS, stdout=sandbox.scratch / "trial")
                if facts.exit_status != 0:
                    raise SandboxError(f"a trial run ended with exit status {facts.exit_status}")
                unless_it_works.pop_all()
                return sandbox
        except (SandboxError, KeyError) as error:
            why = f"{wall.bwrap}: {printable_lines(str(error).encode(), lines=1)}"
    if without_wall:
        return Sandbox(keepers=keepers)
    raise NoWallError(why)
