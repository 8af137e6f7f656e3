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
PRODUCTS, EXACT, START_VALUE = "products", "exact", "start-value"
PRODUCTS_FROM, PRODUCTS_BELOW = 8_000, 150_000  # numbers in whose products 32 bits overflow first
FEW = 0.1  # of all scenes
KNOWS = "It answers every tiny scene of the gallery correctly."
OUT_OF_STEP = "But it does not print one line for each scenario, as the input below shows."
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
    if any(result.mismatch is not None and result.mismatch.out_of_step for result in cases):
        lessons = (_lesson(gallery, ONE_LINE_EACH),)
        return Diagnosis(lessons, None, "", diagnosis.scenes, 0)
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
    sizes = (
        f"(up to {bounds.max_vertices:,} vertices and {bounds.max_scenarios:,} scenarios in a file)"
    )
    if not all(result.case.group in problem.group_names for result in failed):
        return KNOWS
    if all(result.verdict is Verdict.RTE for result in failed):
        return f"{KNOWS} It crashes on larger files: look at array sizes and recursion {sizes}."
    if any(result.case.group in small for result in failed):
        return (
            f"{KNOWS} It fails on small files, too: look for rare positions, or, if the numbers in "
            f"them are large, for rounding and overflow (coordinates go up to "
            f"{bounds.max_coordinate:,})."
        )
    return f"{KNOWS} It fails on large files only: look at fixed sizes and limits on steps {sizes}."


def after_example(gallery: Gallery, diagnosis: Diagnosis, example: Counterexample) -> Diagnosis:
    """Return the diagnosis in the light of a smallest counterexample. Pure.

    Numbers do not shrink below what a bug needs, and tiny polygons can have tiny numbers. Near
    numbers whose products just exceed 32 bits, doubles are still exact.
    """
    largest = max(map(abs, map(int, example.input.split())))
    told = {lesson.id for lesson in diagnosis.lessons}
    if not example.in_step:
        if ONE_LINE_EACH in told:
            return diagnosis
        remark = diagnosis.remark if diagnosis.lessons else f"{KNOWS} {OUT_OF_STEP}"
        lessons = (*diagnosis.lessons, _lesson(gallery, ONE_LINE_EACH))
        return replace(diagnosis, lessons=lessons, remark=remark)
    if not told <= {EXACT, START_VALUE}:
        return diagnosis
    tiny = example.vertices <= gallery.most_vertices
    if tiny and PRODUCTS_FROM <= largest < PRODUCTS_BELOW:
        remark = (
            f"Its smallest counterexample has numbers of {largest:,}: 32 bits are exceeded there."
        )
        lessons = (_lesson(gallery, PRODUCTS), *diagnosis.lessons)
        return replace(diagnosis, lessons=lessons, remark=remark)
    if told or diagnosis.wrong:
        return diagnosis
    if largest < PRODUCTS_FROM:
        return replace(diagnosis, remark=_on_small(gallery, example))
    if tiny and largest >= PRODUCTS_BELOW:
        remark = (
            f"{KNOWS} Its smallest counterexample has numbers of {largest:,}: with small numbers "
            "no wrong answer was found."
        )
        return replace(diagnosis, lessons=(_lesson(gallery, EXACT),), remark=remark)
    return diagnosis


def _lesson(gallery: Gallery, lesson: str) -> MissedLesson:
    return MissedLesson(lesson, gallery.lessons[lesson].sentence, ())


def _on_small(gallery: Gallery, example: Counterexample) -> str:
    """Return what a counterexample with small numbers says of a program that knows the gallery."""
    said = (
        f"{KNOWS[:-1]}, but not the small input below. The numbers in it are small, so it is no "
        "overflow."
    )
    if example.vertices > gallery.most_vertices:
        said += (
            f" It has {example.vertices} vertices, more than any gallery scene: look at what "
            "depends on the number of vertices, such as a limit on steps or the size of an array."
        )
    elif example.special:
        said += f" In it, {'; '.join(example.special)}."
    return said


def _small_groups(problem: Problem) -> frozenset[str]:
    """Return the names of the groups whose files are small by their promise."""
    return frozenset(group.name for group in problem.groups if group.max_vertices is not None)
