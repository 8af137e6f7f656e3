"""Adds a counterexample to the test data, as `python -m gen case --file` does."""

from __future__ import annotations

import io
from contextlib import redirect_stdout
from pathlib import Path

from gen import cli
from gen.added import all_recipes
from gen.validator import InputError, load_rules, validate
from judge.kit.errors import KitError
from judge.kit.paths import DATA
from judge.problem.declaration import load

SAMPLE = "sample"


class AddError(KitError):
    """A counterexample cannot be added to the data."""


def add_to_data(file: Path, group: str = "", data: Path = DATA) -> str:
    """Add an input to a group and return in words what was done.

    group: empty for the first that promises what the input keeps. Nothing is overwritten: the
    name is the file's, which is made of its checksum. Raises AddError.
    """
    chosen = group or fitting_group(file)
    for recipe in all_recipes(data):
        if recipe.name == file.stem:
            return f"in the data already: {recipe.case_name}"
    said = io.StringIO()
    with redirect_stdout(said):
        status = cli.main(["case", "--file", str(file), "--group", chosen, "--data", str(data)])
    if status:
        raise AddError(f"--add: {file} was not added to the group {chosen}")
    return f"added to the data: {said.getvalue().strip()}"


def fitting_group(file: Path) -> str:
    """Return the first group, in order, whose promises an input keeps; no sample."""
    for group in load().group_names:
        if group != SAMPLE and _fits(file, group):
            return group
    raise AddError(f"--add: {file}: expected an input that fits a group, found none")


def _fits(file: Path, group: str) -> bool:
    with file.open("rb") as stream:
        try:
            validate(stream, load_rules(group))
        except InputError:
            return False
    return True
