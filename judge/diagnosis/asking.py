"""Asks a program for its answers to the scenes of the gallery, in as few runs as possible."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from enum import Enum, auto

from judge.diagnosis.gallery import NO_ANSWER, NOT_ASKED, Gallery, Scene, input_file
from judge.diagnosis.shape import letters
from judge.problem.verdict import Verdict
from judge.run import Attempt, Attempts
from judge.sandbox.facts import RunLimits

GALLERY_LIMIT_S = 2.0  # CPU seconds for all scenes together
SCENE_LIMIT_S = 0.5  # for the scenes of one lesson, asked alone
ELAPSED_FACTOR = 4.0  # for a program that sleeps
CHECKED_ALONE = 6  # scenes that are asked again, each alone
ALONE_OF_LESSON, ALONE_AT_MOST = 2, 40  # scenes asked alone when a program is out of step
STALLS = 4  # runs that time out before the rest is left unasked


class Steadiness(Enum):
    """Whether a scene gets the same answer whenever it is asked."""

    STEADY = auto()
    DEPENDS = auto()  # on the scenes before it
    CHANCE = auto()


@dataclass(frozen=True, slots=True)
class Answers:
    """What a program answers.

    letters: one for each scene, Y, N, NO_ANSWER or NOT_ASKED; all are NOT_ASKED if it answered
    none of a few, each asked alone. whole: its run on all scenes at once. in_step: that run
    ended well and gave one answer for each scene. steadiness: as far as it was noticed.
    """

    letters: str
    whole: Attempt
    in_step: bool
    steadiness: Steadiness


def ask(gallery: Gallery, attempts: Attempts, limits: RunLimits) -> Answers:
    """Return the answers of a program. Raises SandboxError.

    attempts: runs it on input files, and yields the runs in order. If the run on all scenes
    (and echoes of some) crashes or is out of step, the scenes of each lesson are asked apart.
    """
    scenes = gallery.asked
    whole_limits = _at_most(limits, GALLERY_LIMIT_S)
    whole = next(attempts([input_file(scenes)], whole_limits))
    found = letters(whole.output)
    if len(found) != len(scenes) or not _ended_well(whole):
        apart = _apart(gallery, attempts, _at_most(limits, SCENE_LIMIT_S))
        return Answers(apart, whole, in_step=False, steadiness=Steadiness.STEADY)
    answers, echoed = found[: len(gallery.scenes)], found[len(gallery.scenes) :]
    wrong = [i for i, scene in enumerate(gallery.scenes) if answers[i] != scene.answer[0]]
    check = [i for i, echo in zip(gallery.echoes, echoed, strict=True) if answers[i] != echo]
    check += wrong[:: max(1, len(wrong) // CHECKED_ALONE)][:CHECKED_ALONE]
    alone = _alone([gallery.scenes[i] for i in check], attempts, _at_most(limits, SCENE_LIMIT_S))
    if all(answers[i] == letter for i, letter in zip(check, alone, strict=True)):
        return Answers(answers, whole, in_step=True, steadiness=Steadiness.STEADY)
    again = next(attempts([input_file(scenes)], whole_limits))
    chance = letters(again.output) != found
    return Answers(
        answers if chance else _apart(gallery, attempts, _at_most(limits, SCENE_LIMIT_S)),
        whole,
        in_step=True,
        steadiness=Steadiness.CHANCE if chance else Steadiness.DEPENDS,
    )


def _apart(gallery: Gallery, attempts: Attempts, limits: RunLimits) -> str:
    """Ask the scenes of each lesson in a file of their own, and some that fail there alone.

    If not one of a few scenes is answered, nothing more is asked.
    """
    found = [NOT_ASKED] * len(gallery.scenes)
    some = gallery.scenes[:: max(1, len(gallery.scenes) // CHECKED_ALONE)][:CHECKED_ALONE]
    if set(_alone(some, attempts, limits)) <= {NO_ANSWER, NOT_ASKED}:
        return "".join(found)
    by_lesson: dict[str, list[int]] = {}
    for index, scene in enumerate(gallery.scenes):
        by_lesson.setdefault(scene.lesson, []).append(index)
    groups = list(by_lesson.values())
    files = (input_file([gallery.scenes[i] for i in group]) for group in groups)
    again: list[int] = []
    for group, attempt in zip(groups, _patient(attempts, files, limits), strict=False):
        right = "".join(gallery.scenes[i].answer[0] for i in group)
        if _ended_well(attempt) and letters(attempt.output) == right:
            for index, letter in zip(group, right, strict=True):
                found[index] = letter
        else:
            again += group[:ALONE_OF_LESSON]
    again = again[:ALONE_AT_MOST]
    answers = _alone([gallery.scenes[i] for i in again], attempts, limits)
    for index, letter in zip(again, answers, strict=True):
        found[index] = letter
    return "".join(found)


def _alone(scenes: Sequence[Scene], attempts: Attempts, limits: RunLimits) -> str:
    """Ask each scene in a file of its own; the first word of the output is the answer."""
    files = (input_file([scene]) for scene in scenes)
    found = ""
    for attempt in _patient(attempts, files, limits):
        given = letters(attempt.output)
        found += given[0] if given and _ended_well(attempt) else NO_ANSWER
    return found.ljust(len(scenes), NOT_ASKED)


def _patient(attempts: Attempts, files: Iterable[bytes], limits: RunLimits) -> Iterator[Attempt]:
    """Yield the runs, in order, until too many have timed out."""
    stalls = 0
    for attempt in attempts(files, limits):
        yield attempt
        stalls += attempt.judgement.verdict is Verdict.TLE
        if stalls == STALLS:
            return


def _ended_well(attempt: Attempt) -> bool:
    return attempt.judgement.verdict is Verdict.AC


def _at_most(limits: RunLimits, seconds: float) -> RunLimits:
    seconds = min(limits.time_limit_s, seconds)
    return limits._replace(time_limit_s=seconds, elapsed_s=ELAPSED_FACTOR * seconds)
