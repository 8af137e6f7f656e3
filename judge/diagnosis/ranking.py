"""Which lessons the answers to the gallery say are missed, most telling first. Pure."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction

from judge.diagnosis.gallery import NO, NO_ANSWER, NOT_ASKED, YES, Gallery, Scene, input_file
from judge.explanation import FailedScene, Like, MissedLesson

NOTHING = "no answer"
NEAR = Fraction(4, 5)  # below it, the nearest known program misleads as often as it helps


def missed_lessons(gallery: Gallery, answers: str) -> tuple[MissedLesson, ...]:
    """Return the lessons that explain the wrong answers, most telling first.

    answers: one letter a scene: Y, N, NO_ANSWER or NOT_ASKED. A known program that
    is wrong in nearly the same scenes decides first. Else each lesson counts by its own scenes
    and by its condition, if it has one. A lesson is told only if it explains an own scene that
    those before it leave. O(lessons * scenes * known).
    """
    wrong = wrong_scenes(gallery, answers)
    known = {name: wrong_scenes(gallery, given) for name, given in gallery.known.items()}
    own: dict[str, list[int]] = {lesson: [] for lesson in gallery.lessons}
    for index in sorted(wrong):
        own[gallery.scenes[index].lesson].append(index)
    first = _lessons_of_nearest(gallery, wrong, known)
    order = list(gallery.lessons)

    def rank(lesson: str) -> tuple[bool, Fraction, int]:
        weight = _by_own_scenes(gallery, lesson, own[lesson], known)
        weight += _by_condition(gallery, lesson, wrong)
        return lesson not in first, -weight, order.index(lesson)

    told = []
    left = set(wrong)
    for lesson in sorted((lesson for lesson in order if own[lesson]), key=rank):
        if left.isdisjoint(own[lesson]):
            continue
        explained = left & _explained(gallery, lesson, known)
        left -= explained
        names = tuple(
            gallery.scenes[i].name
            for i in sorted(explained, key=lambda i: (i not in own[lesson], i))
        )
        smallest = min(own[lesson], key=lambda i: (gallery.scenes[i].size, i))
        scene = _failed(gallery.scenes[smallest], answers[smallest])
        told.append(MissedLesson(lesson, gallery.lessons[lesson].sentence, names, scene))
    return tuple(told)


def wrong_scenes(gallery: Gallery, answers: str) -> frozenset[int]:
    """Return the indices of the scenes that were asked and are not answered correctly."""
    pairs = zip(answers, gallery.expected, strict=True)
    return frozenset(
        index for index, (found, expected) in enumerate(pairs) if found not in (expected, NOT_ASKED)
    )


def _failed(scene: Scene, letter: str) -> FailedScene:
    """Return a scene that got a wrong answer, whose letter is given."""
    found = NOTHING if letter == NO_ANSWER else YES if letter == YES[0] else NO
    return FailedScene(scene.name, input_file([scene]).decode(), scene.answer, found)


def known_alike(gallery: Gallery, answers: str) -> Like | None:
    """Return the known submission that gives exactly these answers; None if they are right."""
    if answers == gallery.expected:
        return None
    for name, given in gallery.known.items():
        if given == answers:
            for lesson in gallery.lessons.values():
                if name in lesson.missed_by:
                    return Like(name, lesson.missed_by[name])
    return None


def _by_own_scenes(
    gallery: Gallery, lesson: str, failed: Iterable[int], known: Mapping[str, frozenset[int]]
) -> Fraction:
    """Weigh the scenes of a lesson that are wrong: the fewer ideas a scene takes, the more.

    The ideas of a scene are the lessons missed by the known programs that are wrong in it.
    """
    weight = Fraction()
    for index in failed:
        ideas = {lesson}
        for name, wrong in known.items():
            if index in wrong:
                ideas |= gallery.lessons_of(name) & gallery.taught
        weight += Fraction(1, len(ideas))
    return weight / (1 + sum(scene.lesson == lesson for scene in gallery.scenes))


def _by_condition(gallery: Gallery, lesson: str, wrong: frozenset[int]) -> Fraction:
    """Compare the wrong scenes with those in which a lesson matters: from -1 to 1.

    1: the same scenes; 0 also for a lesson without a condition; -1: none in common.
    """
    matters = gallery.conditions.get(lesson)
    if not matters or not wrong:
        return Fraction()
    alike = Fraction(len(wrong & matters), len(wrong | matters))
    return alike - Fraction(len(wrong - matters), len(wrong))


def _explained(
    gallery: Gallery, lesson: str, known: Mapping[str, frozenset[int]]
) -> frozenset[int]:
    """Return the scenes that a program which misses this lesson may answer wrongly.

    They are its own, those that meet its condition, and those that known programs fail.
    """
    own = {index for index, scene in enumerate(gallery.scenes) if scene.lesson == lesson}
    failed = (known[name] for name in gallery.lessons[lesson].missed_by if name in known)
    return frozenset(own).union(gallery.conditions.get(lesson, ()), *failed)


def _lessons_of_nearest(
    gallery: Gallery, wrong: frozenset[int], known: Mapping[str, frozenset[int]]
) -> frozenset[str]:
    """Return the lessons of the known program that is wrong in nearly the same scenes, if any."""
    nearest, best = "", Fraction(0)
    for name, others in known.items():
        likeness = Fraction(len(wrong & others), len(wrong | others) or 1)
        if likeness > best:
            nearest, best = name, likeness
    return gallery.lessons_of(nearest) if best >= NEAR else frozenset()
