"""What a case is for, in words: from its family, its counts and the gallery's lessons."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from export.package import Package
from gen.families import FAMILIES
from judge.diagnosis.gallery import load_lessons
from judge.kit.text import counted
from judge.problem.cases import Case
from judge.problem.manifest import Entry

HINTS = Path(__file__).with_name("hints.toml")


@dataclass(frozen=True, slots=True)
class Description:
    """text: what the case holds and is meant to catch. hint: for a program that fails; or ""."""

    text: str
    hint: str


def describe(package: Package, case: Case) -> Description:
    """Return the description of a case, from its entry in the manifest if it has one."""
    entry = package.manifest.cases.get(case.name)
    if entry is None:
        return Description("", "")
    family = FAMILIES.get(entry.family)
    what = f"{family.summary} " if family else ""
    hint = _hints().get(entry.family, "")
    if not package.problem.feedback.lessons:
        hint = ""
    return Description(what + _counts(entry), hint)


def _counts(entry: Entry) -> str:
    return (
        f"{counted(entry.scenarios, 'scenario')} ({entry.yes:,} YES, {entry.no:,} NO) "
        f"with {entry.vertices:,} vertices."
    )


@cache
def _hints() -> dict[str, str]:
    """Return the sentence of the lesson for each family."""
    lessons = load_lessons()
    chosen = tomllib.loads(HINTS.read_text(encoding="utf-8"))
    return {family: lessons[lesson].sentence for family, lesson in chosen.items()}
