"""The scenes of missed lessons as `checker.py --explain` shows them: why, and a picture."""

from __future__ import annotations

from dataclasses import replace

from gen.scenario import parse
from judge.explanation import Diagnosis, FailedScene
from pictures.explain import explain_picture
from pictures.words import sentence
from stress.search.result import keep


def illustrated(diagnosis: Diagnosis) -> Diagnosis:
    """Return the diagnosis with a sentence and a picture for the scene of each lesson.

    The picture is written below build/counterexamples/, and the scene's input beside it.
    """
    lessons = tuple(
        lesson if lesson.scene is None else replace(lesson, scene=_illustrated(lesson.scene))
        for lesson in diagnosis.lessons
    )
    return replace(diagnosis, lessons=lessons)


def _illustrated(scene: FailedScene) -> FailedScene:
    content = scene.input.encode()
    (scenario,) = parse(content)
    title = f"gallery scene {scene.name}"
    picture = explain_picture(scenario, answer=scene.expected, found=scene.found, title=title)
    told = replace(scene, sentence=sentence(scenario), picture=picture)
    try:
        return replace(told, file=keep(content, picture, f"scene-{scene.name}"))
    except OSError:  # a full disk costs the files, not the report
        return told
