"""The mutants that no data can kill, listed by hand in `equivalent.toml`, each with its proof."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Annotated

import msgspec

from judge.kit.errors import KitError
from judge.kit.paths import ROOT
from strength.mutants.mutate import Mutant

FILE = ROOT / "strength" / "equivalent.toml"
ANY = "*"

Words = Annotated[str, msgspec.Meta(min_length=1)]


class EquivalentsError(KitError):
    """The list cannot be used; one clear line."""


class Equivalent(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Changes of one line that change no answer, and why.

    program, function, line, nth: as in `Mutant`. mutated: what the line becomes; `*`: every
    change of the line that survives. That is for lines which decide how fast an answer is
    found but never which one, so that a change can be noticed only if it crashes.
    """

    program: Words
    line: Words
    mutated: Annotated[list[Words], msgspec.Meta(min_length=1)]
    proof: Words
    function: str = ""
    nth: Annotated[int, msgspec.Meta(ge=1)] = 1

    def covers(self, mutant: Mutant) -> bool:
        """Tell whether the mutant is one of these changes."""
        here = (self.program, self.function, self.line)
        if here != (mutant.program, mutant.function, mutant.line):
            return False
        return self.whole_line or (mutant.mutated in self.mutated and mutant.nth == self.nth)

    @property
    def whole_line(self) -> bool:
        """Whether every change of the line that survives is meant."""
        return self.mutated == [ANY]


class _List(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    equivalent: list[Equivalent] = []


def load(path: Path = FILE) -> list[Equivalent]:
    """Return the list in its order. Raises EquivalentsError."""
    try:
        return msgspec.convert(tomllib.loads(path.read_text(encoding="utf-8")), _List).equivalent
    except OSError as error:
        raise EquivalentsError(f"{path}: cannot be read: {error.strerror}") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, msgspec.ValidationError) as error:
        raise EquivalentsError(f"{path}: {error}") from None


def equivalent_of(mutant: Mutant, equivalents: Iterable[Equivalent]) -> Equivalent | None:
    """Return what says that the mutant is equivalent; None if nothing does."""
    return next((one for one in equivalents if one.covers(mutant)), None)


def unused(equivalents: Iterable[Equivalent], mutants: Iterable[Mutant]) -> list[str]:
    """Return a line for each listed change that is no mutant any more."""
    every = list(mutants)
    lines = []
    for one in equivalents:
        own = [mutant for mutant in every if one.covers(mutant)]
        there = {mutant.mutated for mutant in own}
        missing = [text for text in one.mutated if text not in there and text != ANY]
        if one.whole_line and not own:
            missing = [ANY]
        lines += [f"{one.program} {one.function}: {one.line}  ->  {text}" for text in missing]
    return lines
