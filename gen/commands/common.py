"""What several commands share: options, exit statuses, and a warning."""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from pathlib import Path
from typing import TypeAlias

from gen.families import Parameters
from judge.kit.command import Parser, complain
from judge.kit.errors import KitError
from judge.kit.paths import DATA, ROOT

Commands: TypeAlias = "argparse._SubParsersAction[Parser]"

OK, NOT_OK = 0, 1
SHARE_OF_YES = (30, 70)  # per cent; outside, a constant answer is right too often
FEWEST_ANSWERS = 10  # fewer say nothing about a share


class CommandError(KitError):
    """The command makes no sense as given."""


def add_recipe(parser: argparse.ArgumentParser) -> None:
    """Add the options that say how a family makes a file."""
    parser.add_argument("--seed", type=int, help="any integer (default: 1)")
    parser.add_argument(
        "--set",
        action="extend",
        nargs="+",
        default=[],
        metavar="NAME=VALUE",
        help="parameters of the family",
    )


def add_data(parser: argparse.ArgumentParser) -> None:
    """Add the option --data."""
    parser.add_argument("--data", type=Path, default=DATA, help="the data directory")


def parameters(settings: Iterable[str]) -> Parameters:
    """Return the parameters of `--set NAME=VALUE`. Raises CommandError."""
    parameters: dict[str, int | str] = {}
    for setting in settings:
        name, equals, value = setting.partition("=")
        if not equals:
            raise CommandError(f"--set: expected NAME=VALUE, found {setting!r}")
        if name in parameters:
            raise CommandError(f"--set: expected {name} once, found it again: {setting!r}")
        parameters[name] = value
    return parameters


def seed(options: argparse.Namespace) -> int:
    """Return the seed that was asked for, 1 if none was."""
    return 1 if options.seed is None else options.seed


def warn_of_share(name: str, yes: int, no: int) -> None:
    """Say so if so few or so many answers are YES that a constant answer is mostly right."""
    low, high = SHARE_OF_YES
    if yes + no >= FEWEST_ANSWERS and not low * (yes + no) <= 100 * yes <= high * (yes + no):
        constant = "YES" if yes > no else "NO"
        complain(
            f"gen: warning: {name}: {100 * yes // (yes + no)} % of {yes + no} answers are YES "
            f"(expected {low} to {high} %): a program that always says {constant} is mostly right"
        )


def is_ignored(group: str) -> bool:
    """Tell whether the kit's .gitignore names the folder of a group."""
    try:
        lines = (ROOT / ".gitignore").read_text(encoding="utf-8").split()
    except OSError:
        return False
    return f"/data/secret/{group}/" in lines
