"""Diagnoses a program that is not accepted: which lessons it misses, or what else is left."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from judge.diagnosis.asking import Answers, Steadiness, ask
from judge.diagnosis.gallery import NOT_ASKED, Gallery
from judge.diagnosis.ranking import known_alike, missed_lessons, wrong_scenes
from judge.diagnosis.shape import has_other_words, letters, remark_on
from judge.explanation import Counterexample, Diagnosis, MissedLesson
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from judge.results import CaseResult
from judge.run import Attempts
from judge.sandbox.facts import RunLimits

# Lessons that no scene teaches: they show in how the output looks, or in the exit status.
ANSWERS, CHANCE, SEPARATE = "answers", "chance", "separate-scenarios"
ONE_LINE_EACH, EXIT_STATUS = "one-line-each", "exit-status"
PRODUCTS, EXACT = "products", "exact"
PRODUCTS_FROM, PRODUCTS_BELOW = 8_000, 150_000  # numbers in whose products 32 bits overflow first
FEW = 0.1  # of all scenes
DIAGNOSED = (Verdict.WA, Verdict.RTE)


def diagnose(
    gallery: Gallery,
    attempts: Attempts,
    limits: RunLimits,
    problem: Problem,
    cases: Sequence[CaseResult],
) -> Diagnosis | None:
    """Run a program on the gallery and return what that says; None without a WA or RTE.

    attempts: runs the program on input files, and yields the runs in order. cases: the results
    of its judging. Raises SandboxError.
    """
    if not any(result.verdict in DIAGNOSED for result in cases):
        return None
    answers = ask(gallery, attempts, limits)
    diagnosis = read(gallery, answers)
    if diagnosis.lessons or diagnosis.remark:
        return diagnosis
    return Diagnosis((), None, what_is_left(problem, cases), diagnosis.scenes, 0)


def read(gallery: Gallery, answers: Answers) -> Diagnosis:
    """Return what a program's answers to the gallery say. Pure."""
    wrong = wrong_scenes(gallery, answers.letters)
    by_scenes = missed_lessons(gallery, answers.letters)
    by_shape = [
        MissedLesson(lesson, gallery.lessons[lesson].sentence, ())
        for lesson in _lessons_of_shape(gallery, answers)
    ]
    like = known_alike(gallery, answers.letters) if answers.in_step else None
    lessons = (*by_shape, *by_scenes)
    if like is not None:  # its bug is known, so its lessons come first
        missed = gallery.lessons_of(like.submission)
        lessons = tuple(sorted(lessons, key=lambda lesson: lesson.id not in missed))
    if by_shape and by_shape[0].id in (ANSWERS, CHANCE):
        lessons = tuple(by_shape)  # the scenes say nothing about such a program
    elif not answers.in_step and len(wrong) <= FEW * len(gallery.scenes):
        lessons = (*by_scenes, *by_shape)  # it is out of step because of a few scenes
    count = len(gallery.scenes) if set(answers.letters) == {NOT_ASKED} else len(wrong)
    return Diagnosis(lessons, like, _remark(gallery, answers), len(gallery.scenes), count)


def _lessons_of_shape(gallery: Gallery, answers: Answers) -> list[str]:
    whole = answers.whole
    if answers.steadiness is Steadiness.CHANCE:
        return [CHANCE]
    if answers.steadiness is Steadiness.DEPENDS:
        return [SEPARATE]
    asked = len(gallery.asked)
    found = letters(whole.output)
    lessons = []
    if has_other_words(whole.output):
        lessons.append(ONE_LINE_EACH)
    if answers.in_step:
        flipped = gallery.expected.translate(str.maketrans("YN", "NY"))
        if len(set(answers.letters)) == 1 or answers.letters == flipped:
            lessons.append(ANSWERS)
        return lessons
    asked_some = set(answers.letters) != {NOT_ASKED}
    right = asked_some and not wrong_scenes(gallery, answers.letters)
    crashed = whole.judgement.verdict is not Verdict.AC
    if crashed and found[: len(gallery.scenes)] == gallery.expected and len(found) == asked:
        return [EXIT_STATUS]
    if not lessons and not crashed and len(found) != asked:
        lessons.append(ONE_LINE_EACH)
    if right and crashed:
        lessons.append(SEPARATE)
    return lessons


def _remark(gallery: Gallery, answers: Answers) -> str:
    whole = answers.whole
    if whole.judgement.verdict is Verdict.AC:
        expected = "".join(scene.answer[0] for scene in gallery.asked)
        return remark_on(whole.output, expected, [scene.obstacles for scene in gallery.asked])
    if set(answers.letters) == {NOT_ASKED}:
        return f"It answers no scene of the gallery, not even alone: {whole.judgement.message}"
    return ""


def what_is_left(problem: Problem, cases: Sequence[CaseResult]) -> str:
    """Return a sentence for a program that answers the whole gallery correctly. Pure."""
    bounds, small = problem.constraints, _small_groups(problem)
    failed = [result for result in cases if result.verdict in DIAGNOSED]
    right = "It answers every tiny scene of the gallery correctly."
    sizes = (
        f"(up to {bounds.max_vertices:,} vertices and {bounds.max_scenarios:,} scenarios in a file)"
    )
    if not all(result.case.group in problem.group_names for result in failed):
        return right
    if all(result.verdict is Verdict.RTE for result in failed):
        return f"{right} It crashes on larger files: look at array sizes and recursion {sizes}."
    if any(result.case.group in small for result in failed):
        return (
            f"{right} It fails on small files, too: look for rounding or overflow (coordinates go "
            f"up to {bounds.max_coordinate:,}) and for rare positions."
        )
    return f"{right} It fails on large files only: look at fixed sizes and limits on steps {sizes}."


def after_example(gallery: Gallery, diagnosis: Diagnosis, example: Counterexample) -> Diagnosis:
    """Return the diagnosis in the light of a smallest counterexample. Pure.

    Numbers do not shrink below what a bug needs: near those whose products just exceed 32
    bits, doubles are still exact.
    """
    largest = max(map(abs, map(int, example.input.split())))
    if any(lesson.id != EXACT for lesson in diagnosis.lessons):
        return diagnosis
    if PRODUCTS_FROM <= largest < PRODUCTS_BELOW:
        products = MissedLesson(PRODUCTS, gallery.lessons[PRODUCTS].sentence, ())
        remark = (
            f"Its smallest counterexample has numbers of {largest:,}: 32 bits are exceeded there."
        )
        return replace(diagnosis, lessons=(products, *diagnosis.lessons), remark=remark)
    if not diagnosis.lessons and not diagnosis.wrong and largest < PRODUCTS_FROM:
        remark = (
            "It answers every tiny scene of the gallery correctly, but not the small input below: "
            "its numbers are small, so it is no overflow. Look for what is special in it."
        )
        return replace(diagnosis, remark=remark)
    return diagnosis


def _small_groups(problem: Problem) -> frozenset[str]:
    """Return the names of the groups whose files are small by their promise."""
    return frozenset(group.name for group in problem.groups if group.max_vertices is not None)
