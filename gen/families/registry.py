"""How a function becomes a family, and how its parameters are checked."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, get_args, get_type_hints

from gen.rng import Rng, derive
from gen.scenario import LIMIT, Scenario
from judge.kit.errors import KitError
from judge.kit.text import did_you_mean

_INTEGER = re.compile(r"-?[0-9]{1,18}", re.ASCII)


@dataclass(frozen=True)
class Between:
    """The values an integer parameter may have, both ends included."""

    low: int
    high: int

    def read(self, text: int | str) -> int:
        """Return the integer that the text says; ValueError tells what was expected."""
        expected = f"expected an integer of {self.low}..{self.high}, found {str(text)[:40]!r}"
        if not _INTEGER.fullmatch(str(text)):  # int() reads more than anybody writes
            raise ValueError(expected)
        value = int(text)
        if not self.low <= value <= self.high:
            raise ValueError(expected)
        return value


@dataclass(frozen=True)
class OneOf:
    """The words a parameter may be."""

    words: tuple[str, ...]

    def read(self, text: int | str) -> str:
        """Return the word; ValueError tells what was expected."""
        if text not in self.words:
            near = did_you_mean(str(text), self.words)
            raise ValueError(f"expected one of {', '.join(self.words)}, found {text!r}{near}")
        return str(text)


Scenarios = Annotated[int, Between(1, 100_000)]
Vertices = Annotated[int, Between(3, 500_000)]
Length = Annotated[int, Between(1, 2 * LIMIT)]
Far = Annotated[int, Between(0, 2 * LIMIT)]
Move = Annotated[str, OneOf(("any", "zero"))]
Flag = Annotated[int, Between(0, 1)]

Parameters = Mapping[str, int | str]
Maker = Callable[..., Iterable[Scenario]]


class FamilyError(KitError):
    """No such family or parameter, or parameters that no scene fits; one clear line."""


@dataclass(frozen=True)
class Family:
    """A way to make test cases: a function of a random source and keyword parameters."""

    name: str
    room: str  # the folder below gen/families/ that holds it, named after what it attacks
    summary: str
    make: Maker
    domains: Mapping[str, Between | OneOf]
    defaults: Parameters

    def resolve(self, given: Parameters) -> dict[str, int | str]:
        """Return all parameters, checked; FamilyError names the first bad one."""
        for name in given:
            if name not in self.domains:
                near = did_you_mean(name, self.domains)
                raise FamilyError(f"family {self.name}: no parameter {name!r}{near}")
        resolved = {}
        for name, domain in self.domains.items():
            try:
                resolved[name] = domain.read(given.get(name, self.defaults[name]))
            except ValueError as error:
                raise FamilyError(f"family {self.name}: parameter {name}: {error}") from None
        return resolved

    def scenarios(self, given: Parameters, repeat: int) -> list[Scenario]:
        """Return the scenarios for these parameters; equal arguments, equal scenarios."""
        parameters = self.resolve(given)
        return list(self.make(Rng(derive(self.name, parameters, repeat)), **parameters))


FAMILIES: dict[str, Family] = {}  # filled once, by the decorator, while gen.families loads


def family(make: Maker) -> Maker:
    """Register a function as the family of its name; its docstring's first line sums it up.

    Every keyword parameter has a default, and an annotation that says which values it may
    have. Raises ValueError if not, or if the name is taken.
    """
    hints: dict[str, Any] = get_type_hints(make, include_extras=True)
    parameters = [p for p in inspect.signature(make).parameters.values() if p.name != "rng"]
    name = make.__name__
    if name in FAMILIES and FAMILIES[name].make.__module__ != make.__module__:
        raise ValueError(f"family {name}: defined in {make.__module__} and before")
    for parameter in parameters:
        if parameter.default is parameter.empty or len(get_args(hints[parameter.name])) < 2:
            raise ValueError(
                f"family {name}: parameter {parameter.name}: expected a default, and an "
                "annotation of its values, such as Scenarios"
            )
    FAMILIES[name] = Family(
        name=name,
        room=_room(make.__module__),
        summary=(make.__doc__ or "").partition("\n")[0],
        make=make,
        domains={p.name: get_args(hints[p.name])[1] for p in parameters},
        defaults={p.name: p.default for p in parameters},
    )
    return make


def _room(module: str) -> str:
    """Return the room of a family by its module: `gen.families.size.hugging` is in `size`.

    >>> _room("gen.families.size.hugging"), _room("gen.families.mine")
    ('size', '')
    """
    return ".".join(module.split(".")[2:-1])


def find(name: str) -> Family:
    """Return the family of this name; FamilyError suggests the nearest."""
    try:
        return FAMILIES[name]
    except KeyError:
        hint = did_you_mean(name, FAMILIES) or f"; expected one of {', '.join(FAMILIES)}"
        raise FamilyError(f"no family {name!r}{hint}") from None
