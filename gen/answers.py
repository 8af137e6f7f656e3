"""Answers: by the reference, confirmed by a second method that shares no code with it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from math import comb
from pathlib import Path

from gen.scenario import Scenario
from judge.kit.errors import KitError
from judge.kit.paths import BRUTE_FORCE, REFERENCE, SUBMISSIONS
from judge.kit.trusted import python_command, read_answers, run_trusted
from judge.problem.manifest import Entry, sum_of

TEXTBOOK = SUBMISSIONS / "accepted" / "textbook.py"
SEPARATING_AXIS = SUBMISSIONS / "accepted" / "separating_axis.py"

_BRUTE_EDGE_PAIRS = 3_000_000  # a few seconds
_TEXTBOOK_STEPS = 1_500_000
_MOST_GUESSES = 1_000  # cheaper than to start the reference


class DisagreementError(KitError):
    """Two methods disagree on a case."""


def answer_file(program: Path, content: bytes, scenarios: int) -> bytes:
    """Return the answer file that a program of the kit gives. Raises ProgramError."""
    output = run_trusted(program.name, python_command(program), content)
    return _lines(read_answers(program.name, output, scenarios))


def agreed(content: bytes, scenarios: Sequence[Scenario]) -> bytes:
    """Return the answer file of an input, by two methods.

    Raises DisagreementError naming the first scenario that they answer differently, and
    ProgramError.
    """
    second = second_method(scenarios)
    answers = answer_file(REFERENCE, content, len(scenarios))
    others = answer_file(second, content, len(scenarios))
    for number, (one, other) in enumerate(
        zip(answers.decode().split(), others.decode().split(), strict=True), start=1
    ):
        if one != other:
            raise DisagreementError(
                f"scenario {number}: {REFERENCE.name} says {one}, {second.name} says {other}"
            )
    return answers


def second_method(scenarios: Sequence[Scenario]) -> Path:
    """Return the naive method if it is fast enough, else one different from the reference."""
    edge_pairs = sum(len(s.robot) * sum(map(len, s.obstacles)) for s in scenarios)
    if edge_pairs <= _BRUTE_EDGE_PAIRS:
        return BRUTE_FORCE
    steps = sum(len(s.robot) * len(s.obstacles) for s in scenarios)
    return TEXTBOOK if steps <= _TEXTBOOK_STEPS else SEPARATING_AXIS


def recorded_answers(entry: Entry) -> bytes | None:
    """Return the answer file that the manifest describes, if few files come into question.

    The entry says how many answers are YES and how many are NO. With all of them equal, or
    few scenarios, the file is found by its checksum, without the reference. None: too many.
    """
    total = entry.yes + entry.no
    if comb(total, entry.yes) > _MOST_GUESSES:
        return None
    for chosen in combinations(range(total), entry.yes):
        answers = ["NO"] * total
        for index in chosen:
            answers[index] = "YES"
        content = _lines(answers)
        if sum_of(content) == entry.answer:
            return content
    return None


def _lines(answers: Sequence[str]) -> bytes:
    return "".join(f"{answer}\n" for answer in answers).encode()
