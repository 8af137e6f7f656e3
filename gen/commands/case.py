"""`gen case`: add a test case to the data."""

from __future__ import annotations

import argparse
import io
from pathlib import Path

from gen.added import all_recipes, load_added, save_added
from gen.build import BuildError, build_cases
from gen.commands.common import (
    OK,
    CommandError,
    Commands,
    add_data,
    add_recipe,
    is_ignored,
    parameters,
    seed,
    warn_of_share,
)
from gen.families import find
from gen.plan import HAND_MADE, NAME, NAME_FORM, Recipe
from gen.validator import InputError, load_rules, validate
from judge.kit.command import complain
from judge.kit.files import write_whole
from judge.problem.manifest import load_manifest, save_manifest


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    case = commands.add_parser("case", help="add a test case of your own to the data")
    case.add_argument("family", nargs="?", metavar="FAMILY", help="the family that makes it")
    case.add_argument("--file", type=Path, help="an input written by hand, instead of a family")
    add_recipe(case)
    case.add_argument("--group", required=True, help="the group it goes to")
    case.add_argument("--name", help="its name (default: the family's and the seed, or FILE's)")
    add_data(case)
    case.set_defaults(command=run)


def run(options: argparse.Namespace) -> int:
    """Add the case, and say how many answers are YES. Raises KitError."""
    data: Path = options.data
    load_rules(options.group)
    content = None
    if options.file is None:
        recipe = _generated(options)
    else:
        recipe, content = _hand_written(options)
    if any(recipe.case_name == other.case_name for other in all_recipes(data)):
        other_seed = "" if options.file else " or --seed"
        raise CommandError(
            f"{recipe.case_name}: is there already; choose another --name{other_seed}"
        )
    entries = dict(load_manifest(data).cases)
    path = data / f"{recipe.case_name}.in"
    if content is not None:
        write_whole(path, content, parents=True)
    try:
        built = build_cases(
            data, [recipe], {}, update=True, verify=True, jobs=1, done=lambda _: None
        )
    except BaseException:
        if content is not None:
            path.unlink()
        raise
    entry = built[recipe.case_name]
    same = [name for name, other in entries.items() if other.input == entry.input]
    save_added(data, [*load_added(data), recipe])
    save_manifest(data, entries | built)
    print(f"{recipe.case_name}: {entry.yes} YES, {entry.no} NO")
    for name in same:
        complain(f"gen: warning: {recipe.case_name}: the same input as {name}")
    if content is not None and is_ignored(recipe.group):
        complain(
            f"gen: warning: {recipe.case_name}: git ignores files of this group: keep your own copy"
        )
    warn_of_share(recipe.case_name, entry.yes, entry.no)
    return OK


def _generated(options: argparse.Namespace) -> Recipe:
    """Return the recipe of an added case of a family. Raises CommandError, FamilyError."""
    if options.family is None:
        raise CommandError("case: expected a FAMILY, or --file with an input written by hand")
    family, repeat = find(options.family), seed(options)
    name = options.name or f"{family.name.replace('_', '-')}-{repeat}"
    if not NAME.fullmatch(name):
        too_long = "" if options.name else "; the seed is too long for one: give a name"
        raise CommandError(f"--name: expected {NAME_FORM}, found {name!r}{too_long}")
    resolved = family.resolve(parameters(options.set))
    return Recipe(options.group, name, family.name, resolved, repeat)


def _hand_written(options: argparse.Namespace) -> tuple[Recipe, bytes]:
    """Return the recipe and the content of a valid input written by hand.

    Raises CommandError; BuildError if the input is not valid.
    """
    if options.family is not None or options.set or options.seed is not None:
        raise CommandError("case: expected --file alone, or a FAMILY with its --seed and --set")
    file: Path = options.file
    name = options.name or file.stem
    if not NAME.fullmatch(name):
        raise CommandError(f"--name: expected {NAME_FORM}, found {name!r}; give a name")
    content = file.read_bytes()
    try:
        validate(io.BytesIO(content), load_rules(options.group))
    except InputError as fault:
        raise BuildError(f"{file}:{fault.line}: {fault.reason}") from None
    return Recipe(options.group, name, HAND_MADE), content
