"""The scenes that the page holds: every scenario of the samples, and the gallery."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from gen.scenario import parse, render
from judge.diagnosis.gallery import GALLERY, load_gallery
from judge.kit.errors import KitError
from judge.kit.paths import DATA, ROOT

STATEMENT = ROOT / "problem.md"
_SAMPLE = re.compile(r"^### Sample \d+: (.+?)$\n(.*?)^Input:$", re.MULTILINE | re.DOTALL)
_FIGURE = re.compile(r"^!\[.*?\]\(.*?\)$", re.MULTILINE | re.DOTALL)


class SceneError(KitError):
    """The samples are not in the form that the page needs."""


@dataclass(frozen=True)
class Scene:
    """A scene of the page. input: one scenario, without the number of scenarios before it.

    name: what a link calls it (`#gallery=NAME`). title, sentence: for people. Scenes of one
    lesson share their sentence.
    """

    name: str
    group: str
    title: str
    sentence: str
    answer: str
    input: str


def samples(data: Path = DATA, statement: Path = STATEMENT) -> list[Scene]:
    """Return every scenario of the samples, with the stories of the statement."""
    stories = _SAMPLE.findall(statement.read_text(encoding="utf-8"))
    files = sorted((data / "sample").glob("*.in"))
    if len(stories) != len(files):
        raise SceneError(f"{statement}: expected {len(files)} samples, found {len(stories)}")
    scenes = []
    for file, (title, text) in zip(files, stories, strict=True):
        sentence = " ".join(_FIGURE.sub("", text).split()).replace("$", "")
        answers = file.with_suffix(".ans").read_text(encoding="ascii").split()
        scenarios = parse(file.read_bytes())
        for number, (scenario, answer) in enumerate(zip(scenarios, answers, strict=True), start=1):
            scenes.append(
                Scene(
                    name=f"{file.stem}-{number}",
                    group="Samples of the statement",
                    title=f"{title}, scenario {number}",
                    sentence=sentence,
                    answer=answer,
                    input=render([scenario]).decode().partition("\n")[2],
                )
            )
    return scenes


def gallery(directory: Path = GALLERY) -> list[Scene]:
    """Return the scenes of the gallery, grouped by their lessons. Raises GalleryError."""
    found = load_gallery(directory)
    order = list(found.lessons)
    return [
        Scene(
            name=scene.name,
            group=f"Gallery: {_words(scene.lesson)}",
            title=_words(scene.name),
            sentence=found.lessons[scene.lesson].sentence,
            answer=scene.answer,
            input=scene.input,
        )
        for scene in sorted(found.scenes, key=lambda scene: order.index(scene.lesson))
    ]


def _words(name: str) -> str:
    return name.replace("-", " ")
