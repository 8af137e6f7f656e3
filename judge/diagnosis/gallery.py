"""Loads the gallery: lessons, tiny scenes that teach them, and how known programs answer these."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, TypeVar

import msgspec

from judge.kit.errors import KitError
from judge.kit.paths import DATA

GALLERY = DATA / "gallery"
LESSONS, SCENES, ANSWERS = "lessons.toml", "scenes.toml", "answers.json"
ECHOES = 8  # scenes that are asked a second time: another answer shows what was kept
YES, NO = "YES", "NO"
NO_ANSWER = "-"  # the program crashed, ran out of time, or did not print an answer
NOT_ASKED = " "

T = TypeVar("T")


class GalleryError(KitError):
    """The gallery cannot be used; the message says where, expected and found."""


class Lesson(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One idea, in a sentence, and the wrong submissions that miss exactly it.

    missed_by: path in submissions/ to the bug, in words that complete "a program that ...".
    """

    sentence: str
    missed_by: dict[str, str] = {}


class Scene(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One scenario of the gallery, with its answer, in the lesson that it teaches.

    input: its lines of an input file, without the number of scenarios. matters: the lessons
    whose condition it meets: a program that misses only one of the others with a condition
    answers it correctly (see `strength.gallery.conditions`). made: how the scenario
    was found (see `strength.gallery.pool`), empty if it was written by hand.
    """

    name: str
    lesson: str
    answer: str
    input: str
    matters: frozenset[str] = frozenset()
    made: dict[str, Any] = {}

    @property
    def obstacles(self) -> int:
        """The number of its obstacles."""
        return int(self.input.split(maxsplit=2)[1])

    @property
    def vertices(self) -> int:
        """The number of its vertices: a line each, after two lines, and one for each obstacle."""
        return self.input.count("\n") - 2 - self.obstacles

    @property
    def size(self) -> tuple[int, int]:
        """The number of its lines, then of its characters: the least is the simplest to look at."""
        return self.input.count("\n"), len(self.input)


class SceneFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The content of `scenes.toml`."""

    scenes: list[Scene]


@dataclass(frozen=True)
class Gallery:
    """The lessons by id, most basic first; the scenes in their order; known answers.

    known: the answers of wrong submissions to all scenes, one letter Y or N each.
    """

    lessons: Mapping[str, Lesson]
    scenes: tuple[Scene, ...]
    known: Mapping[str, str]

    @cached_property
    def expected(self) -> str:
        """The right answers to all scenes, one letter Y or N each."""
        return "".join(scene.answer[0] for scene in self.scenes)

    @cached_property
    def taught(self) -> frozenset[str]:
        """The lessons that have scenes; the others show in the shape of the output."""
        return frozenset(scene.lesson for scene in self.scenes)

    @cached_property
    def most_vertices(self) -> int:
        """The number of vertices of its largest scene."""
        return max((scene.vertices for scene in self.scenes), default=0)

    @cached_property
    def conditions(self) -> Mapping[str, frozenset[int]]:
        """By lesson, the indices of the scenes in which it matters, if it has a condition."""
        return {
            lesson: found
            for lesson in self.lessons
            if (found := frozenset(i for i, s in enumerate(self.scenes) if lesson in s.matters))
        }

    @cached_property
    def echoes(self) -> tuple[int, ...]:
        """The indices of the scenes that the whole file asks again at its end."""
        step = max(1, len(self.scenes) // ECHOES)
        return tuple(range(0, len(self.scenes), step)[:ECHOES])

    @cached_property
    def asked(self) -> tuple[Scene, ...]:
        """All scenes, then the echoes: what the whole file asks."""
        return (*self.scenes, *(self.scenes[index] for index in self.echoes))

    def lessons_of(self, submission: str) -> frozenset[str]:
        """Return the lessons that a known submission misses."""
        return frozenset(i for i, lesson in self.lessons.items() if submission in lesson.missed_by)


def input_file(scenes: Sequence[Scene]) -> bytes:
    """Return an input file with these scenes."""
    return f"{len(scenes)}\n{''.join(scene.input for scene in scenes)}".encode()


def load_lessons(directory: Path = GALLERY) -> dict[str, Lesson]:
    """Return the lessons by id, in their order. Raises GalleryError."""
    return _read(directory / LESSONS, dict[str, Lesson])


def load_gallery(directory: Path = GALLERY) -> Gallery:
    """Return the gallery of a directory. Raises GalleryError."""
    lessons = load_lessons(directory)
    scenes = tuple(_read(directory / SCENES, SceneFile).scenes)
    known = _read(directory / ANSWERS, dict[str, str])
    _check(lessons, scenes, known, directory)
    return Gallery(lessons, scenes, known)


def _check(
    lessons: Mapping[str, Lesson],
    scenes: Sequence[Scene],
    known: Mapping[str, str],
    directory: Path,
) -> None:
    names: set[str] = set()
    for scene in scenes:
        where = f"{directory / SCENES}: scene {scene.name!r}"
        if scene.name in names:
            raise GalleryError(f"{where}: the name occurs twice")
        if scene.lesson not in lessons:
            raise GalleryError(f"{where}: {LESSONS} has no lesson {scene.lesson!r}")
        if scene.answer not in (YES, NO):
            raise GalleryError(f"{where}: expected the answer YES or NO, found {scene.answer!r}")
        if unknown := sorted(scene.matters - lessons.keys()):
            raise GalleryError(f"{where}: {LESSONS} has no lesson {unknown[0]!r}")
        names.add(scene.name)
    for submission, answers in known.items():
        if len(answers) != len(scenes):
            raise GalleryError(
                f"{directory / ANSWERS}: {submission}: expected {len(scenes)} answers, found "
                f"{len(answers)}; run 'make gallery'"
            )


def _read(path: Path, kind: type[T]) -> T:
    try:
        text = path.read_text(encoding="utf-8")
        table = msgspec.json.decode(text) if path.suffix == ".json" else tomllib.loads(text)
        return msgspec.convert(table, kind)
    except OSError as error:
        raise GalleryError(f"{path}: cannot be read: {error.strerror}") from None
    except (UnicodeDecodeError, tomllib.TOMLDecodeError, msgspec.MsgspecError) as error:
        raise GalleryError(f"{path}: {error}") from None
