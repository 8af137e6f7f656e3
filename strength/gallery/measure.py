"""Measures the gallery: does every wrong submission fail, and is its true lesson named first?"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from judge.diagnosis.asking import Answers, Steadiness
from judge.diagnosis.diagnose import read
from judge.diagnosis.gallery import Gallery
from judge.diagnosis.ranking import wrong_scenes

FEWEST = 2  # scenes that a submission fails, if a tiny scenario can catch it


@dataclass(frozen=True, slots=True)
class Measured:
    """One wrong submission on the gallery, its own answers and those of its twins unknown.

    wrong: how many scenes it fails. named: the lessons told, most telling first. true: those
    that it misses.
    """

    submission: str
    wrong: int
    named: tuple[str, ...]
    true: frozenset[str]

    @property
    def first_is_true(self) -> bool:
        """Whether the first lesson named is a true one."""
        return bool(self.named) and self.named[0] in self.true


def steady_answers(answers: Mapping[str, Answers]) -> dict[str, str]:
    """Return the answers that can be compared: in step, and not by chance."""
    return {
        name: given.letters
        for name, given in answers.items()
        if given.in_step and given.steadiness is Steadiness.STEADY
    }


def measure(gallery: Gallery, answers: Mapping[str, Answers]) -> list[Measured]:
    """Return how well each submission is diagnosed by what is known of the others."""
    return [_measured(gallery, name, given) for name, given in answers.items()]


def _measured(gallery: Gallery, name: str, given: Answers) -> Measured:
    others = {n: a for n, a in gallery.known.items() if n != name and a != given.letters}
    without = Gallery(gallery.lessons, gallery.scenes, others)
    named = tuple(lesson.id for lesson in read(without, given).lessons)
    return Measured(
        name, len(wrong_scenes(gallery, given.letters)), named, gallery.lessons_of(name)
    )


def faults(measured: Sequence[Measured], gallery: Gallery) -> list[str]:
    """Return a line for each submission that should fail more scenes than it does."""
    return [
        f"{one.submission}: expected to fail at least {FEWEST} scenes, fails {one.wrong}"
        for one in measured
        if one.true & gallery.taught and one.wrong < FEWEST
    ]
