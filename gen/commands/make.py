"""`gen make`: print a file of a family."""

from __future__ import annotations

import argparse
import sys

from gen.answers import answer_file
from gen.build import render_family
from gen.commands.common import OK, Commands, add_recipe, parameters, seed, warn_of_share
from judge.kit.paths import REFERENCE


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    make = commands.add_parser("make", help="print a valid file of a family")
    make.add_argument("family", metavar="FAMILY")
    add_recipe(make)
    make.set_defaults(command=run)


def run(options: argparse.Namespace) -> int:
    """Write a valid file to standard output. Raises KitError."""
    content = render_family(options.family, parameters(options.set), seed(options))
    sys.stdout.buffer.write(content)
    sys.stdout.buffer.flush()
    scenarios = int(content[: content.index(b"\n")])
    answers = answer_file(REFERENCE, content, scenarios)
    warn_of_share(f"family {options.family}", answers.count(b"YES"), answers.count(b"NO"))
    return OK
