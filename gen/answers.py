"""Answers: by the reference, agreed by a second method that shares nothing with it."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from gen.scenario import Scenario
from judge.kit.errors import KitError
from judge.kit.paths import ROOT

REFERENCE = ROOT / "solution.py"
BRUTE_FORCE = ROOT / "brute.py"
TEXTBOOK = ROOT / "submissions" / "accepted" / "textbook.py"
SEPARATING_AXIS = ROOT / "submissions" / "accepted" / "separating_axis.py"

_TIMEOUT_S = 300.0
_BRUTE_EDGE_PAIRS = 3_000_000  # a few seconds
_TEXTBOOK_STEPS = 1_500_000


class AnswerError(KitError):
    """A method failed, or wrote something that is no answer; one clear line."""


class DisagreementError(KitError):
    """Two methods disagree on a case; one clear line."""


def second_method(scenarios: Sequence[Scenario]) -> Path:
    """Return the naive method if it is fast enough, else one different from the reference."""
    edge_pairs = sum(len(s.robot) * sum(map(len, s.obstacles)) for s in scenarios)
    if edge_pairs <= _BRUTE_EDGE_PAIRS:
        return BRUTE_FORCE
    steps = sum(len(s.robot) * len(s.obstacles) for s in scenarios)
    return TEXTBOOK if steps <= _TEXTBOOK_STEPS else SEPARATING_AXIS


def agreed(content: bytes, scenarios: Sequence[Scenario]) -> bytes:
    """Return the answer file for an input; DisagreementError names the first other scenario."""
    second = second_method(scenarios)
    answers = answer(REFERENCE, content, len(scenarios))
    others = answer(second, content, len(scenarios))
    for number, (one, other) in enumerate(zip(answers, others, strict=True), start=1):
        if one != other:
            raise DisagreementError(
                f"scenario {number}: {REFERENCE.name} says {one}, {second.name} says {other}"
            )
    return ("\n".join(answers) + "\n").encode()


def answer(program: Path, content: bytes, scenarios: int) -> list[str]:
    """Run a method of the kit on an input and return its YES and NO, one per scenario."""
    try:
        run = subprocess.run(
            [sys.executable, str(program)],
            input=content,
            capture_output=True,
            timeout=_TIMEOUT_S,
            check=False,
        )
    except subprocess.TimeoutExpired:
        raise AnswerError(f"{program.name}: no answer within {_TIMEOUT_S:.0f} s") from None
    if run.returncode != 0:
        last = run.stderr.decode(errors="replace").strip().rpartition("\n")[2]
        raise AnswerError(f"{program.name}: exit status {run.returncode}: {last}")
    lines = run.stdout.decode(errors="replace").splitlines()
    if len(lines) != scenarios or not set(lines) <= {"YES", "NO"}:
        raise AnswerError(f"{program.name}: expected {scenarios} lines of YES or NO, found others")
    return lines
