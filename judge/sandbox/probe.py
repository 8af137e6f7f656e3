"""Finds a wall that stands on this machine: by a real launch, never by its mere presence."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass, replace

from judge.kit.text import printable_lines
from judge.sandbox.facts import RunLimits
from judge.sandbox.sandbox import Command, Sandbox, SandboxError
from judge.sandbox.wall import Wall, candidates

PROBE_LIMITS = RunLimits(time_limit_s=2.0, memory_mib=64, output_mib=1)


@dataclass(frozen=True, slots=True)
class Probe:
    """The wall that stands, or None and why none does."""

    wall: Wall | None
    why: str = ""


def probe() -> Probe:
    """Try every candidate in turn. About 20 ms."""
    why = "no bwrap is installed"
    for wall in candidates():
        try:
            with Sandbox(wall) as sandbox:
                output = sandbox.scratch / "probe"
                facts = sandbox.run(Command(("/bin/sh", "-c", ":")), PROBE_LIMITS, stdout=output)
        except (SandboxError, KeyError) as error:
            why = f"{wall.bwrap}: {printable_lines(str(error).encode(), lines=1)}"
            continue
        if facts.exit_status == 0:
            return Probe(replace(wall, version=_version(wall)))
        why = f"{wall.bwrap}: a trial run ended with exit status {facts.exit_status}"
    return Probe(None, why)


def _version(wall: Wall) -> str:
    """Return what a working bwrap calls itself, `bubblewrap 0.11.0`, or nothing."""
    try:
        asked = subprocess.run(
            [wall.bwrap, "--version"], capture_output=True, env={}, timeout=10, check=True
        )
    except (OSError, subprocess.SubprocessError):
        return ""
    return printable_lines(asked.stdout, lines=1, width=40)
