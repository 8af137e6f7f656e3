"""`gen remove`: remove a test case that was added."""

from __future__ import annotations

import argparse
from pathlib import Path

from gen.added import find_added, load_added, save_added
from gen.commands.common import OK, Commands, add_data
from judge.problem.manifest import load_manifest, save_manifest


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    remove = commands.add_parser("remove", help="remove a test case that was added by 'case'")
    remove.add_argument("name", metavar="NAME", help="such as secret/small/contacts-7")
    add_data(remove)
    remove.set_defaults(command=run)


def run(options: argparse.Namespace) -> int:
    """Remove the case and its files. Raises KitError."""
    data: Path = options.data
    recipe = find_added(options.name, data)
    name = recipe.case_name
    entries = dict(load_manifest(data).cases)
    entries.pop(name, None)
    save_added(data, [other for other in load_added(data) if other.case_name != name])
    save_manifest(data, entries)
    for ending in (".in", ".ans"):
        (data / f"{name}{ending}").unlink(missing_ok=True)
    print(f"{name}: removed")
    return OK
