"""Chooses the scenes of the gallery: for each wrong submission, the ones that tell most."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from gen.scenario import Scenario, render
from judge.diagnosis.gallery import NO, YES, Lesson, Scene
from strength.gallery.conditions import conditions_of, obstacles_met
from strength.gallery.pool import Candidate

PER_SUBMISSION = 2
PER_LESSON = 4
MOST_SCENES = 150
COMPARED = 60  # of the best candidates: the one most unlike the lesson's other scenes is taken
# In such scenes a program that prints a line for each hit is out of step. No wrong answer shows it.
TWO_HIT_LESSON, TWO_HIT = "every-obstacle", 2


def choose(
    pool: Sequence[Candidate], right: str, answers: Mapping[str, str], lessons: Mapping[str, Lesson]
) -> list[Scene]:
    """Return scenes such that each submission fails two, if it fails any of the pool.

    right: the answers to the pool, one letter each; answers: those of each submission. Best is
    a scene that the programs of few other lessons fail, that many of its own lesson fail, and
    that is small. Among the best, later scenes of a lesson are taken for being unlike those
    before. Programs that fail half of the pool, or always say the same, have no scenes.
    """
    fails = {
        name: frozenset(i for i, (a, b) in enumerate(zip(given, right, strict=True)) if a != b)
        for name, given in answers.items()
        if len(set(given)) > 1
    }
    fails = {name: found for name, found in fails.items() if 2 * len(found) < len(pool)}
    killers: list[list[str]] = [[] for _ in pool]
    for name, found in fails.items():
        for index in found:
            killers[index].append(name)
    choice = _Choice(pool)
    by_lesson: dict[str, list[int]] = {}
    for lesson, content in lessons.items():
        own = [name for name in content.missed_by if name in fails]

        def cost(index: int, own: Sequence[str] = own) -> tuple[int, int, tuple[int, int, int]]:
            mates = sum(name in own for name in killers[index])
            return len(killers[index]) - mates, -mates, pool[index].size

        for name in own:
            have = sum(choice.lesson.get(i) == lesson for i in fails[name])
            choice.take(lesson, sorted(fails[name], key=cost), PER_SUBMISSION - have)
        by_lesson[lesson] = sorted(frozenset().union(*(fails[name] for name in own)), key=cost)
    two_hit = (i for i in sorted(range(len(pool)), key=lambda i: pool[i].size) if _two_hit(pool[i]))
    choice.take(TWO_HIT_LESSON, list(two_hit), TWO_HIT)
    for count in range(PER_SUBMISSION + 1, PER_LESSON + 1):
        for lesson, best in by_lesson.items():
            have = sum(taught == lesson for taught in choice.lesson.values())
            choice.take(lesson, best, min(count - have, MOST_SCENES - len(choice.lesson)))
    return _named(choice.lesson, pool, right, lessons)


@dataclass(frozen=True)
class _Choice:
    """The candidates taken so far, each with the lesson that it teaches."""

    pool: Sequence[Candidate]
    lesson: dict[int, str] = field(default_factory=dict)
    features: dict[int, frozenset[str]] = field(default_factory=dict)

    def take(self, lesson: str, best: Sequence[int], count: int) -> None:
        """Add up to `count` of the candidates, best first, that are not taken yet."""
        for _ in range(count):
            left = [index for index in best if index not in self.lesson][:COMPARED]
            if not left:
                return
            taken = [index for index, taught in self.lesson.items() if taught == lesson]
            self.lesson[max(left, key=lambda i: self._unlike(i, taken))] = lesson

    def _unlike(self, index: int, taken: Iterable[int]) -> int:
        """Return in how many features a candidate differs at least from each of the others."""
        mine = self._features(index)
        return min((len(mine ^ self._features(other)) for other in taken), default=0)

    def _features(self, index: int) -> frozenset[str]:
        if index not in self.features:
            self.features[index] = features_of(self.pool[index].scenario)
        return self.features[index]


def features_of(scenario: Scenario) -> frozenset[str]:
    """Return what can be the same or different in two scenes: conditions met, and directions."""
    dx, dy = scenario.move
    (x, y), *_ = scenario.robot
    found = {
        *(name for name, holds in (("right", dx > 0), ("up", dy > 0), ("left", dx < 0)) if holds),
        *(["steep"] if abs(dy) > abs(dx) else []),
        *(["begins left"] if x == min(a for a, _ in scenario.robot) else []),
        *(["begins low"] if y == min(b for _, b in scenario.robot) else []),
        *(["two"] if len(scenario.obstacles) > 1 else []),
    }
    return conditions_of(scenario) | found


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
