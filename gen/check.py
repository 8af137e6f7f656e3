"""Checks data: each file against the grammar and its group, each case against the manifest."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from gen.build import changes
from gen.plan import Recipe
from gen.validator import InputError, Rules, Summary, load_rules, validate
from judge.kit.checksums import Checksums
from judge.problem.manifest import Entry, file_faults, load_manifest


def check_file(path: Path, rules: Rules, name: str = "") -> list[str]:
    """Return what is wrong with an input file, one line each; [] if nothing is."""
    summary = _validated(path, rules, name or str(path))
    return summary if isinstance(summary, list) else []


def check_data(data: Path, recipes: Iterable[Recipe], checksums: Checksums) -> list[str]:
    """Return what is wrong with a data directory, one line each: files, entries, strays."""
    entries = load_manifest(data).cases
    faults: list[str] = []
    listed = {recipe.case_name: recipe for recipe in recipes}
    for name, recipe in listed.items():
        if name in entries:
            faults += _check_case(data, recipe, entries[name], checksums)
        else:
            faults.append(f"{name}: in the plan or added, but not in the manifest")
    faults += [
        f"{name}: in the manifest, but neither in the plan nor added"
        for name in entries
        if name not in listed
    ]
    for folder in ("sample", "secret"):
        for file in sorted((data / folder).rglob("*")):
            name = file.relative_to(data).with_suffix("").as_posix()
            if file.is_file() and name not in listed:
                faults.append(f"{file.relative_to(data)}: no case of the plan, and none added")
    checksums.keep()
    return faults


def _check_case(data: Path, recipe: Recipe, entry: Entry, checksums: Checksums) -> list[str]:
    name = recipe.case_name
    faults = [
        f"{path.relative_to(data)}: {fault}"
        for path, fault in file_faults(data, name, entry, checksums)
    ]
    changed = changes(recipe, entry)
    if changed:
        faults.append(f"{name}: the manifest says otherwise in {', '.join(changed)}")
    path = data / f"{name}.in"
    if not path.exists():
        return faults  # said already
    summary = _validated(path, load_rules(recipe.group), f"{name}.in")
    if isinstance(summary, list):
        return faults + summary
    figures = ("scenarios", "vertices", "pair_sum")
    return faults + [
        f"{name}.in: {figure}: the manifest says {getattr(entry, figure)}, "
        f"found {getattr(summary, figure)}"
        for figure in figures
        if getattr(entry, figure) != getattr(summary, figure)
    ]


def _validated(path: Path, rules: Rules, name: str) -> Summary | list[str]:
    """Return what a valid file holds, or else what is wrong with it."""
    try:
        with path.open("rb") as stream:
            return validate(stream, rules)
    except InputError as fault:
        return [f"{name}:{fault.line}: {fault.reason}"]
    except OSError as error:
        return [f"{name}: cannot be read: {error.strerror}"]
