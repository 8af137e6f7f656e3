"""`gen check`: hold files, or all of the data, to what is valid."""

from __future__ import annotations

import argparse
from pathlib import Path

from gen.added import all_recipes
from gen.check import check_data, check_file
from gen.commands.common import NOT_OK, OK, CommandError, Commands, add_data
from gen.validator import load_rules
from judge.kit.checksums import Checksums
from judge.kit.command import add_jobs, complain
from judge.kit.processors import processors
from judge.kit.store import Store
from judge.problem.declaration import load
from judge.problem.manifest import MANIFEST


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    check = commands.add_parser("check", help="validate files; without FILE: all of the data")
    check.add_argument("files", nargs="*", type=Path, metavar="FILE")
    check.add_argument("--group", help="hold the files to this group's promises too")
    add_jobs(check, processors(), "cases checked")
    add_data(check)
    check.set_defaults(command=run)


def run(options: argparse.Namespace) -> int:
    """Name every fault; without one, say what was checked. Raises KitError."""
    if options.files:
        rules = load_rules(options.group)
        faults = [fault for file in options.files for fault in check_file(file, rules)]
        checked = f"{len(options.files)} files"
    else:
        if options.group is not None:
            raise CommandError("--group: expected FILE with it; all of the data is held to its own")
        load()  # the whole declaration is held to its form, not only what the validator reads
        if not (options.data / MANIFEST).is_file():
            raise CommandError(f"--data: expected a data directory, found {options.data}")
        recipes = all_recipes(options.data)
        with Store() as store:
            faults = check_data(options.data, recipes, Checksums(store), options.jobs)
        checked = f"{len(recipes)} cases"
    for fault in faults:
        complain(fault)
    if not faults:
        print(f"{checked}: valid")
    return NOT_OK if faults else OK
