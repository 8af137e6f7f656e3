"""The plan, `gen/plan.toml`: how every test case of the kit is made. Loaded, checked, frozen."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any, TypeVar

import msgspec

from gen.families import FamilyError, find
from judge.kit.errors import KitError
from judge.kit.paths import ROOT
from judge.kit.text import did_you_mean
from judge.problem.declaration import load

PLAN = ROOT / "gen" / "plan.toml"
HAND_MADE = ""  # stands for the family of a case whose .in is written by hand
NAME = re.compile(r"[a-z0-9][a-z0-9_-]{0,60}")
NAME_FORM = "1 to 61 small letters, digits and dashes"

Parameters = Mapping[str, int | str]
T = TypeVar("T", bound=msgspec.Struct)


class PlanError(KitError):
    """A list of test cases, the plan or the added ones, cannot be used."""


@dataclass(frozen=True, slots=True)
class Recipe:
    """How one test case is made.

    repeat: tells apart cases of equal family and parameters; part of the seed.
    """

    group: str
    name: str
    family: str = HAND_MADE
    parameters: Parameters = field(default_factory=dict)
    repeat: int = 1

    @property
    def case_name(self) -> str:
        """The name of the case, in the manifest and everywhere: `secret/large/03-contacts`."""
        below = "sample" if self.group == "sample" else f"secret/{self.group}"
        return f"{below}/{self.name}"

    def resolved(self) -> dict[str, int | str]:
        """Return all parameters, sorted by name, defaults filled in. Raises FamilyError."""
        if self.family == HAND_MADE:
            return {}
        return dict(sorted(find(self.family).resolve(self.parameters).items()))


class PlannedCase(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One case as the plan's file says it."""

    family: str = HAND_MADE
    use: list[str] = []
    parameters: dict[str, int | str] = {}
    repeat: Annotated[int, msgspec.Meta(ge=1)] = 1


class PlanFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The plan's file: shared parameters by name; cases, not yet checked, by group and name."""

    shared: dict[str, dict[str, int | str]]
    cases: dict[str, dict[str, Any]]


def load_plan(path: Path = PLAN) -> tuple[Recipe, ...]:
    """Return the planned cases in their order. Raises PlanError with one clear line."""
    file = strict(read_toml(path), PlanFile, str(path))
    groups = load().group_names
    recipes = []
    for group, cases in file.cases.items():
        for name, table in cases.items():
            where = f"{path}: cases.{group}.{name}"
            case = strict(table, PlannedCase, where)
            parameters: dict[str, int | str] = {}
            for shared in case.use:
                if shared not in file.shared:
                    near = did_you_mean(shared, file.shared)
                    raise PlanError(f"{where}: use: no shared parameters {shared!r}{near}")
                parameters |= file.shared[shared]
            parameters |= case.parameters
            recipe = Recipe(group, name, case.family, parameters, case.repeat)
            check_recipe(recipe, groups, where)
            recipes.append(recipe)
    return tuple(recipes)


def check_recipe(recipe: Recipe, groups: Sequence[str], where: str) -> None:
    """Raise PlanError unless group, name, family and parameters are good ones."""
    if recipe.group not in groups:
        raise PlanError(f"{where}: no group {recipe.group!r}{did_you_mean(recipe.group, groups)}")
    if not NAME.fullmatch(recipe.name):
        raise PlanError(f"{where}: name: expected {NAME_FORM}, found {recipe.name!r}")
    if recipe.family == HAND_MADE and (recipe.parameters or recipe.repeat != 1):
        raise PlanError(f"{where}: expected a family, since it has parameters or a repeat")
    try:
        recipe.resolved()
    except FamilyError as error:
        raise PlanError(f"{where}: {error}") from None


def read_toml(path: Path) -> dict[str, Any]:
    """Return the content of a TOML file. Raises PlanError, FileNotFoundError."""
    try:
        return tomllib.loads(path.read_bytes().decode())
    except FileNotFoundError:
        raise
    except OSError as error:
        raise PlanError(f"{path}: cannot be read: {error.strerror}") from None
    except UnicodeDecodeError as error:
        raise PlanError(f"{path}: not UTF-8 text (byte {error.start})") from None
    except tomllib.TOMLDecodeError as error:
        raise PlanError(f"{path}: not valid TOML: {error}") from None


def strict(table: object, kind: type[T], where: str) -> T:
    """Return a table as a struct. Raises PlanError: `where: what`, a suggestion for a bad key."""
    if isinstance(table, dict):
        known = kind.__struct_fields__
        for key in table:
            if key not in known:
                near = did_you_mean(key, known) or f"; expected one of {', '.join(known)}"
                raise PlanError(f"{where}: unknown key {key!r}{near}")
    try:
        return msgspec.convert(table, kind)
    except msgspec.ValidationError as error:
        what, _, at = str(error).partition(" - at ")
        key = at.strip("`").removeprefix("$").removeprefix(".")
        raise PlanError(f"{where}: {key}: {what}" if key else f"{where}: {what}") from None
