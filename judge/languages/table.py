"""The languages a submission may be written in, as `languages.toml` declares them."""

from __future__ import annotations

import tomllib
from pathlib import Path, PurePath
from typing import Annotated

import msgspec

from judge.kit.errors import KitError
from judge.kit.text import did_you_mean

FILE = Path(__file__).with_name("languages.toml")

Words = Annotated[tuple[str, ...], msgspec.Meta(min_length=1)]


class LanguageError(KitError):
    """The language is not known, or its tools are not installed."""


class Language(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One language; the head of `languages.toml` explains the fields."""

    name: str
    suffixes: Words
    tools: Words
    compile: Words
    run: Words
    hints: Words
    error_line: str = ""
    error_place: str = ""
    newest_call_last: bool = False
    env: dict[str, str] = {}
    isolated_python: bool = False


class _Table(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    languages: tuple[Language, ...]


LANGUAGES = msgspec.convert(tomllib.loads(FILE.read_text(encoding="utf-8")), _Table).languages


def by_name(name: str) -> Language:
    """Return the language called `name`; case and spaces do not matter (`python`, `C++`, `cpp`).

    Raises LanguageError, which lists the known names.
    """
    wanted = _plain(name)
    for language in LANGUAGES:
        plain = _plain(language.name)
        if wanted in {plain, plain.rstrip("3"), *(s.removeprefix(".") for s in language.suffixes)}:
            return language
    names = [language.name for language in LANGUAGES]
    near = did_you_mean(wanted, map(_plain, names))
    raise LanguageError(f"unknown language {name!r}{near}; expected one of {', '.join(names)}")


def by_suffix(path: PurePath) -> Language | None:
    """Return the language that has the suffix of `path`, None if there is none."""
    suffix = path.suffix.lower()
    return next((language for language in LANGUAGES if suffix in language.suffixes), None)


def _plain(name: str) -> str:
    return name.lower().replace(" ", "").replace("c++", "cpp")
