"""Writes the generated files of the gallery: scenes.toml and answers.json."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import msgspec

from judge.diagnosis.gallery import ANSWERS, SCENES, Scene
from judge.kit.files import write_whole

HEAD = """\
# The scenes of the gallery: the choice of `python -m strength gallery --choose`, as data. `made`
# tells how each was made; the scenario is reproduced from it. `matters` names the lessons whose
# condition it meets. Lessons are in lessons.toml.
"""


def scenes_text(scenes: Sequence[Scene]) -> str:
    """Return the content of scenes.toml."""
    return HEAD + "".join(map(_scene, scenes))


def save_scenes(directory: Path, scenes: Sequence[Scene]) -> None:
    """Write scenes.toml."""
    write_whole(directory / SCENES, scenes_text(scenes).encode())


def answers_text(known: Mapping[str, str]) -> bytes:
    """Return the content of answers.json: one line for each submission."""
    return msgspec.json.format(msgspec.json.encode(dict(sorted(known.items()))), indent=1) + b"\n"


def save_answers(directory: Path, known: Mapping[str, str]) -> None:
    """Write answers.json."""
    write_whole(directory / ANSWERS, answers_text(known))


def _scene(scene: Scene) -> str:
    lines = ["", "[[scenes]]"]
    lines += [f'{key} = "{getattr(scene, key)}"' for key in ("name", "lesson", "answer")]
    if scene.matters:
        lines.append(f"matters = {_value(sorted(scene.matters))}")
    if scene.made:
        lines.append(f"made = {_table(scene.made)}")
    return "\n".join([*lines, f'input = """\n{scene.input}"""', ""])


def _table(table: Mapping[str, Any]) -> str:
    return "{ " + ", ".join(f"{key} = {_value(value)}" for key, value in table.items()) + " }"


def _value(value: Any) -> str:
    if isinstance(value, dict):
        return _table(value)
    if isinstance(value, list):
        return "[" + ", ".join(map(_value, value)) + "]"
    return f'"{value}"' if isinstance(value, str) else str(value)
