"""Which lessons the answers to the gallery say are missed, most telling first. Pure."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction

from judge.diagnosis.gallery import NOT_ASKED, Gallery
from judge.explanation import Like, MissedLesson

NEAR = Fraction(4, 5)  # below it, the nearest known program misleads as often as it helps
NO_OBSTACLES, STANDING_STILL = "no-obstacles", "standing-still"


def missed_lessons(
    gallery: Gallery, answers: str, leave_out: Iterable[str] = ()
) -> tuple[MissedLesson, ...]:
    """Return the lessons of the scenes that are answered wrongly, most telling first.

    answers: one letter a scene: Y, N, NO_ANSWER or NOT_ASKED. leave_out: known submissions
    to ignore. A scene is the more telling, the fewer ideas it takes: its weight is
    one over the number of lessons that known programs, wrong in it, miss. A lesson's weight is
    the sum over its scenes answered wrongly, divided by one more than the number of its scenes.
    Two things decide before the weights: that it fails just the scenes without obstacles or
    without a move, and a known program that is wrong in nearly the same scenes.
    """
    wrong = wrong_scenes(gallery, answers)
    known = {
        name: wrong_scenes(gallery, given)
        for name, given in gallery.known.items()
        if name not in frozenset(leave_out)
    }
    lessons: dict[str, list[int]] = {}
    for index in sorted(wrong):
        lessons.setdefault(gallery.scenes[index].lesson, []).append(index)
    first = _lessons_of_property(gallery, wrong) or _lessons_of_nearest(gallery, wrong, known)
    order = list(gallery.lessons)

    def rank(lesson: str) -> tuple[bool, Fraction, int]:
        scenes = sum(scene.lesson == lesson for scene in gallery.scenes)
        weight = sum((_weight(gallery, i, known) for i in lessons[lesson]), Fraction())
        return lesson not in first, -weight / (1 + scenes), order.index(lesson)

    return tuple(
        MissedLesson(
            lesson,
            gallery.lessons[lesson].sentence,
            tuple(gallery.scenes[index].name for index in lessons[lesson]),
        )
        for lesson in sorted(lessons, key=rank)
    )


def wrong_scenes(gallery: Gallery, answers: str) -> frozenset[int]:
    """Return the indices of the scenes that were asked and are not answered correctly."""
    pairs = zip(answers, gallery.expected, strict=True)
    return frozenset(
        index for index, (found, expected) in enumerate(pairs) if found not in (expected, NOT_ASKED)
    )


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


def _weight(gallery: Gallery, index: int, known: dict[str, frozenset[int]]) -> Fraction:
    ideas = {gallery.scenes[index].lesson}
    for name, wrong in known.items():
        if index in wrong:
            ideas |= gallery.lessons_of(name) & gallery.taught
    return Fraction(1, len(ideas))


def _lessons_of_property(gallery: Gallery, wrong: frozenset[int]) -> frozenset[str]:
    """Return the lesson on a property that all wrong scenes have, and nearly all with it fail."""
    properties = {
        NO_OBSTACLES: {i for i, scene in enumerate(gallery.scenes) if not scene.obstacles},
        STANDING_STILL: {i for i, scene in enumerate(gallery.scenes) if scene.stands_still},
    }
    expected = {gallery.expected[i] for i in wrong}
    for lesson, having in properties.items():
        same = {i for i in having if gallery.expected[i] in expected}
        if wrong and wrong <= having and len(wrong) >= NEAR * len(same):
            return frozenset({lesson})
    return frozenset()


def _lessons_of_nearest(
    gallery: Gallery, wrong: frozenset[int], known: dict[str, frozenset[int]]
) -> frozenset[str]:
    """Return the lessons of the known program that is wrong in nearly the same scenes, if any."""
    nearest, best = "", Fraction(0)
    for name, others in known.items():
        likeness = Fraction(len(wrong & others), len(wrong | others) or 1)
        if likeness > best:
            nearest, best = name, likeness
    return gallery.lessons_of(nearest) if best >= NEAR else frozenset()
