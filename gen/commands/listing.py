"""`gen list`: the families, their parameters, and all cases."""

from __future__ import annotations

import argparse

from gen.added import all_recipes
from gen.commands.common import OK, Commands, add_data
from gen.families import FAMILIES


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    listing = commands.add_parser("list", help="the families, their parameters, and all cases")
    add_data(listing)
    listing.set_defaults(command=run)


def run(options: argparse.Namespace) -> int:
    """Print both tables. Raises KitError."""
    from rich.table import Table

    from judge.kit.console import PlainConsole

    console = PlainConsole()
    families = Table("family", "in", "makes", "parameters")
    for family in FAMILIES.values():
        defaults = " ".join(f"{name}={value}" for name, value in family.defaults.items())
        families.add_row(family.name, family.room, family.summary, defaults)
    cases = Table("case", "family", "parameters", "repeat")
    for recipe in all_recipes(options.data):
        given = " ".join(f"{name}={value}" for name, value in recipe.parameters.items())
        cases.add_row(recipe.case_name, recipe.family or "(hand-made)", given, str(recipe.repeat))
    console.print(families)
    console.print(cases)
    return OK
