"""Finds a wall that works on this machine, by a trial launch."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from judge.kit.text import printable_lines
from judge.sandbox.facts import RunLimits
from judge.sandbox.sandbox import Command, Sandbox, SandboxError
from judge.sandbox.wall import Wall, candidates

PROBE_LIMITS = RunLimits(time_limit_s=2.0, memory_mib=64, output_mib=1)


class NoWallError(SandboxError):
    """No wall works on this machine; the message says why."""


@dataclass(frozen=True, slots=True)
class Probe:
    """The wall that works; or None, and why no wall does."""

    wall: Wall | None
    why: str = ""


def probe() -> Probe:
    """Try every candidate in turn. About 40 ms."""
    try:
        with walled_sandbox() as sandbox:
            return Probe(sandbox.wall)
    except NoWallError as error:
        return Probe(None, str(error))


def walled_sandbox(keepers: int = 1, hidden: tuple[Path, ...] = ()) -> Sandbox:
    """Return a sandbox whose wall works, after one trial run in it. Raises NoWallError.

    keepers: as of `Sandbox`; hidden: as of `Wall`.
    """
    why = "no bwrap is installed"
    for wall in candidates(hidden):
        try:
            return _tried(Sandbox(wall, keepers))
        except (SandboxError, KeyError) as error:
            why = f"{wall.bwrap}: {printable_lines(str(error).encode(), lines=1)}"
    raise NoWallError(why)


def _tried(sandbox: Sandbox) -> Sandbox:
    """Return the sandbox after a trial run; close it if that fails. Raises SandboxError."""
    output = sandbox.scratch / "probe"
    try:
        facts = sandbox.run(Command(("/bin/sh", "-c", ":")), PROBE_LIMITS, stdout=output)
        if facts.exit_status != 0:
            raise SandboxError(f"a trial run ended with exit status {facts.exit_status}")
    except BaseException:
        sandbox.close()
        raise
    return sandbox
