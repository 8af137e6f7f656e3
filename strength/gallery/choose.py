"""Chooses the scenes of the gallery: for each wrong submission, the ones that tell most."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gen.scenario import render
from judge.diagnosis.gallery import NO, YES, Lesson, Scene
from strength.gallery.conditions import conditions_of
from strength.gallery.pool import Candidate

PER_SUBMISSION = 2
PER_LESSON = 4


def choose(
    pool: Sequence[Candidate], right: str, answers: Mapping[str, str], lessons: Mapping[str, Lesson]
) -> list[Scene]:
    """Return scenes such that each submission fails two, if it fails any of the pool.

    right: the answers to the pool, one letter each; answers: those of each submission. Best is
    a scene that the programs of few other lessons fail, that many of its own lesson fail, and
    that is small. Programs that fail half of the pool, or always say the same, have no scenes.
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
    chosen: dict[int, str] = {}
    for lesson, content in lessons.items():
        own = [name for name in content.missed_by if name in fails]

        def cost(index: int, own: Sequence[str] = own) -> tuple[int, int, tuple[int, int, int]]:
            mates = sum(name in own for name in killers[index])
            return len(killers[index]) - mates, -mates, pool[index].size

        for name in own:
            have = sum(chosen[i] == lesson for i in chosen if i in fails[name])
            _take(chosen, lesson, sorted(fails[name], key=cost), PER_SUBMISSION - have)
        every = sorted(frozenset().union(*(fails[name] for name in own)), key=cost)
        have = sum(taught == lesson for taught in chosen.values())
        _take(chosen, lesson, every, PER_LESSON - have)
    return _named(chosen, pool, right, lessons)


def _take(chosen: dict[int, str], lesson: str, best: Sequence[int], count: int) -> None:
    """Add up to `count` of the candidates that are not chosen yet."""
    new = [index for index in best if index not in chosen][: max(0, count)]
    chosen.update(dict.fromkeys(new, lesson))


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
