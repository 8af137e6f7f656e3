"""The mutants that no data can kill, listed by hand in `equivalent.toml`, each with its proof."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Annotated

import msgspec

from judge.kit.errors import KitError
from strength.mutate import Mutant

FILE = Path(__file__).with_name("equivalent.toml")
ANY = "*"

Words = Annotated[str, msgspec.Meta(min_length=1)]


class EquivalentsError(KitError):
    """The list cannot be used; one clear line."""


class Entry(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Changes of one line that change no answer, and why.

    program, function, line, nth: as in `Mutant`. mutated: what the line becomes, or
    `*` for whatever survives of the line: when it decides how fast an answer is found,
    never which, though a change may still crash.
    """

    program: Words
    line: Words
    mutated: Annotated[list[Words], msgspec.Meta(min_length=1)]
    proof: Words
    function: str = ""
    nth: Annotated[int, msgspec.Meta(ge=1)] = 1

    def covers(self, mutant: Mutant) -> bool:
        """Tell whether this entry names the mutant."""
        here = (self.program, self.function, self.line)
        if here != (mutant.program, mutant.function, mutant.line):
            return False
        return self.whole_line or (mutant.mutated in self.mutated and mutant.nth == self.nth)

    @property
    def whole_line(self) -> bool:
        """Whether it speaks of all survivors of its line."""
        return self.mutated == [ANY]


class _List(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    equivalent: list[Entry] = []


def load(path: Path = FILE) -> list[Entry]:
    """Return the entries in order. Raises EquivalentsError."""
    try:
        return msgspec.convert(tomllib.loads(path.read_text(encoding="utf-8")), _List).equivalent
    except OSError as error:
        raise EquivalentsError(f"{path}: cannot be read: {error.strerror}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, msgspec.ValidationError) as error:
        raise EquivalentsError(f"{path}: {error}") from None


def entry_of(mutant: Mutant, entries: Iterable[Entry]) -> Entry | None:
    """Return the entry that names the mutant, if one does."""
    return next((entry for entry in entries if entry.covers(mutant)), None)


def unused(entries: Iterable[Entry], mutants: Iterable[Mutant]) -> list[str]:
    """Return a line for each entry, or change of one, that names no mutant any more."""
    every = list(mutants)
    lines = []
    for entry in entries:
        own = [mutant for mutant in every if entry.covers(mutant)]
        there = {mutant.mutated for mutant in own}
        missing = [text for text in entry.mutated if text not in there and text != ANY]
        if entry.whole_line and not own:
            missing = [ANY]
        lines += [f"{entry.program} {entry.function}: {entry.line}  ->  {m}" for m in missing]
    return lines
