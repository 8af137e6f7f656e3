"""Test cases that users added, listed in `data/cases.toml`; every build makes them too."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

import msgspec

from gen.plan import HAND_MADE, PlanError, Recipe, check_recipe, load_plan, read_toml, strict
from judge.kit.files import write_whole
from judge.kit.paths import DATA
from judge.kit.text import did_you_mean
from judge.problem.declaration import load

ADDED = "cases.toml"
HEAD = "# Cases added with `python -m gen case`; every build makes them as the plan's own.\n"


class AddedCase(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One case as the list says it; family: empty for a hand-written one."""

    group: str
    name: str
    family: str = HAND_MADE
    parameters: dict[str, int | str] = {}
    repeat: int = 1


class AddedFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The list; its cases are not yet checked."""

    case: list[dict[str, object]] = []


def load_added(data: Path = DATA) -> tuple[Recipe, ...]:
    """Return the cases that users added. Raises PlanError if their list cannot be used."""
    path = data / ADDED
    try:
        file = strict(read_toml(path), AddedFile, str(path))
    except FileNotFoundError:
        return ()
    found: dict[str, Recipe] = {}
    groups = load().group_names
    planned = {recipe.case_name for recipe in load_plan()}
    for number, table in enumerate(file.case, start=1):
        where = f"{path}: case {number}"
        case = strict(table, AddedCase, where)
        recipe = Recipe(case.group, case.name, case.family, case.parameters, case.repeat)
        check_recipe(recipe, groups, where)
        if recipe.case_name in planned:
            raise PlanError(f"{where}: {recipe.case_name} is a case of the plan: choose a new name")
        if recipe.case_name in found:
            raise PlanError(f"{where}: {recipe.case_name} stands in the list twice")
        found[recipe.case_name] = recipe
    return tuple(found.values())


def save_added(data: Path, recipes: Sequence[Recipe]) -> None:
    """Write the list of added cases; without any, there is no such file."""
    path = data / ADDED
    if recipes:
        write_whole(path, (HEAD + "".join(map(_entry, recipes))).encode(), parents=True)
    else:
        path.unlink(missing_ok=True)


def all_recipes(data: Path = DATA) -> tuple[Recipe, ...]:
    """Return the planned cases, then those that users added. Raises PlanError."""
    return load_plan() + load_added(data)


def find_added(name: str, data: Path) -> Recipe:
    """Return the added case of this name, whole or its last parts (`small/mine`, `mine`).

    Raises PlanError if there is none, several, or if it is a case of the plan.
    """
    added = load_added(data)
    matches = _matching(name, added)
    if len(matches) > 1:
        names = ", ".join(recipe.case_name for recipe in matches)
        raise PlanError(f"{name!r} is the name of several added cases: {names}")
    if matches:
        return matches[0]
    planned = _matching(name, load_plan())
    if planned:
        raise PlanError(
            f"{planned[0].case_name} is a case of the plan: take it out of gen/plan.toml, "
            "then build with --update-manifest"
        )
    near = did_you_mean(name, [n for r in added for n in (r.case_name, r.name)])
    raise PlanError(f"no added case {name!r}{near}; {data / ADDED} lists them")


def _matching(name: str, recipes: Iterable[Recipe]) -> list[Recipe]:
    return [recipe for recipe in recipes if f"/{recipe.case_name}".endswith(f"/{name}")]


def _entry(recipe: Recipe) -> str:
    """Return the lines of the list that describe a case."""
    lines = [f"group = {_toml(recipe.group)}", f"name = {_toml(recipe.name)}"]
    if recipe.family != HAND_MADE:
        pairs = (f"{name} = {_toml(value)}" for name, value in sorted(recipe.parameters.items()))
        lines += [
            f"family = {_toml(recipe.family)}",
            f"parameters = {{ {', '.join(pairs)} }}",
            f"repeat = {recipe.repeat}",
        ]
    return "\n[[case]]\n" + "".join(f"{line}\n" for line in lines)


def _toml(value: int | str) -> str:
    """Return an integer or a plain word (no quotes, no control characters) as TOML."""
    return str(value) if isinstance(value, int) else f'"{value}"'
