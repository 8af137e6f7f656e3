"""Chooses the scenes of the gallery: for each wrong submission, the ones that tell most."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from gen.scenario import render
from judge.diagnosis.gallery import NO, YES, Lesson, Scene
from strength.gallery.conditions import conditions_of, obstacles_met
from strength.gallery.features import LARGE, NUMBERS, SPECIAL, features_of
from strength.gallery.pool import Candidate

PER_SUBMISSION = 2
PER_LESSON, PER_NUMBERS = 4, 6  # an overflow fails only about every other scene
MOST_SCENES = 150
COMPARED = 32  # candidates for each submission
# In such scenes a program that prints a line for each hit is out of step: no answer is wrong.
TWO_HIT_LESSON, TWO_HIT = "every-obstacle", 2

# By lesson and submission that misses it: the indices of candidates that it fails, best first.
Shortlist = Mapping[str, Mapping[str, Sequence[int]]]
# By submission: the indices of candidates that each of its mutants fails.
Mutants = Mapping[str, Sequence[frozenset[int]]]


def shortlist(
    pool: Sequence[Candidate], right: str, answers: Mapping[str, str], lessons: Mapping[str, Lesson]
) -> Shortlist:
    """Return the best candidates for each submission in each lesson that it misses.

    right: the answers to the pool, one letter each; answers: those of each submission. Best is
    a scene that the programs of few other lessons fail, that meets the lesson's condition and
    is special in no other way, that many of its own lesson fail, and that is small. Large
    numbers are the last resort. Programs that fail half of the pool, or always say the same,
    have no scenes. O(pool * submissions).
    """
    fails = {name: failed(given, right) for name, given in answers.items() if len(set(given)) > 1}
    fails = {name: found for name, found in fails.items() if 2 * len(found) < len(pool)}
    killers: list[list[str]] = [[] for _ in pool]
    for name, found in fails.items():
        for index in found:
            killers[index].append(name)
    meets = [conditions_of(candidate.scenario) for candidate in pool]
    with_condition = frozenset[str]().union(*meets)
    short: dict[str, dict[str, list[int]]] = {}
    for lesson, content in lessons.items():
        own = [name for name in content.missed_by if name in fails]

        def cost(
            index: int, lesson: str = lesson, own: Sequence[str] = own
        ) -> tuple[bool, int, int, tuple[int, int, int]]:
            mates = sum(name in own for name in killers[index])
            wanted = with_condition & {lesson}
            strange = meets[index] & (SPECIAL | {lesson}) ^ wanted
            if lesson in LARGE:
                strange -= NUMBERS - {lesson}
            large = not strange.isdisjoint(NUMBERS)
            return large, len(killers[index]) - mates + len(strange), -mates, pool[index].size

        short[lesson] = {name: sorted(fails[name], key=cost)[:COMPARED] for name in own}
    return short


def failed(given: str, right: str) -> frozenset[int]:
    """Return the indices at which two texts of answers differ."""
    return frozenset(i for i, (a, b) in enumerate(zip(given, right, strict=True)) if a != b)


def mutants_of(answers: Mapping[str, str], some: Sequence[int], right: str) -> Mutants:
    """Return what the mutants of each submission fail.

    answers: of each submission, to some candidates in one disguise, then in the next, and so
    on. some: the indices of these candidates; right: the answers to the pool.
    """
    expected, count = "".join(right[i] for i in some), len(some)
    return {
        name: [
            frozenset(some[i] for i in failed(given[at : at + count], expected))
            for at in range(0, len(given), count)
        ]
        for name, given in answers.items()
    }


def choose(
    pool: Sequence[Candidate],
    right: str,
    short: Shortlist,
    mutants: Mutants,
    lessons: Mapping[str, Lesson],
) -> list[Scene]:
    """Return scenes such that each submission fails two, if it fails any of the pool.

    Of the candidates in the shortlist, one comes first that mutants of the lesson's submissions
    fail which pass the scenes before, then one that is unlike these scenes.
    """
    mutants = {
        name: mutants.get(name) or [frozenset(found)]
        for best in short.values()
        for name, found in best.items()
    }
    choice = _Choice(pool, mutants)
    for lesson, best in short.items():
        for name in best:
            have = sum(choice.lesson.get(i) == lesson for i in mutants[name][0])
            choice.take(lesson, best, best[name], PER_SUBMISSION - have)
    two_hit = (i for i in sorted(range(len(pool)), key=lambda i: pool[i].size) if _two_hit(pool[i]))
    choice.take(TWO_HIT_LESSON, (), list(two_hit)[:COMPARED], TWO_HIT)
    rounds = [(lesson, PER_NUMBERS) for lesson in short if lesson in NUMBERS]
    rounds += [(n, count) for count in range(PER_SUBMISSION + 1, PER_LESSON + 1) for n in short]
    for lesson, count in rounds:
        best = short[lesson]
        have = sum(taught == lesson for taught in choice.lesson.values())
        every = [index for indices in zip(*best.values(), strict=False) for index in indices]
        choice.take(lesson, best, every, min(count - have, MOST_SCENES - len(choice.lesson)))
    return _named(choice.lesson, pool, right, lessons)


@dataclass(frozen=True)
class _Choice:
    """The candidates taken so far, each with the lesson that it teaches."""

    pool: Sequence[Candidate]
    mutants: Mutants
    lesson: dict[int, str] = field(default_factory=dict)

    def take(self, lesson: str, own: Iterable[str], best: Sequence[int], count: int) -> None:
        """Add up to `count` of the candidates, best first, that are not taken yet.

        own: the submissions that miss the lesson.
        """
        for _ in range(count):
            left = [index for index in best if index not in self.lesson]
            if not left:
                return
            taken = {index for index, taught in self.lesson.items() if taught == lesson}
            alive = [m for name in own for m in self.mutants[name] if m.isdisjoint(taken)]
            features = [features_of(self.pool[index].scenario) for index in taken]

            def value(
                index: int,
                alive: Sequence[frozenset[int]] = alive,
                features: Sequence[frozenset[str]] = features,
            ) -> tuple[int, int]:
                mine = features_of(self.pool[index].scenario)
                unlike = min((len(mine ^ other) for other in features), default=0)
                return sum(index in mutant for mutant in alive), unlike

            self.lesson[max(left, key=value)] = lesson


def _two_hit(candidate: Candidate) -> bool:
    scenario = candidate.scenario
    return len(scenario.obstacles) > 1 and obstacles_met(scenario) > 1


def _named(
    chosen: Mapping[int, str],
    pool: Sequence[Candidate],
    right: str,
    lessons: Mapping[str, Lesson],
) -> list[Scene]:
    """Return the scenes, by lesson and size, called LESSON-1, LESSON-2, ..."""
    scenes = []
    for lesson in lessons:
        own = [index for index, taught in chosen.items() if taught == lesson]
        for number, index in enumerate(sorted(own, key=lambda i: pool[i].size), 1):
            text = render([pool[index].scenario]).decode().partition("\n")[2]
            answer = YES if right[index] == "Y" else NO
            matters = conditions_of(pool[index].scenario) & lessons.keys()
            name = f"{lesson}-{number}"
            scenes.append(Scene(name, lesson, answer, text, matters, pool[index].made))
    return scenes
