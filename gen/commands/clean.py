"""`gen clean`: delete the large files that every build makes again, and nothing else."""

from __future__ import annotations

import argparse
from pathlib import Path

from gen.added import all_recipes
from gen.commands.common import OK, Commands, add_data, is_ignored
from gen.plan import HAND_MADE
from judge.kit.text import counted
from judge.problem.declaration import load


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    clean = commands.add_parser("clean", help="delete the large files that a build makes again")
    add_data(clean)
    clean.set_defaults(command=run)


def run(options: argparse.Namespace) -> int:
    """Delete them, and say what is kept in their folders."""
    data: Path = options.data
    made = {recipe.case_name for recipe in all_recipes(data) if recipe.family != HAND_MADE}
    deleted, kept = 0, []
    for group in filter(is_ignored, load().group_names):
        folder = data / "secret" / group
        for path in sorted(folder.glob("*")):
            if path.suffix in (".in", ".ans") and f"secret/{group}/{path.stem}" in made:
                path.unlink()
                deleted += 1
            else:
                kept.append(path)
        if folder.is_dir() and not any(folder.iterdir()):
            folder.rmdir()
    print(f"{counted(deleted, 'file')} deleted, which `gen build` makes again")
    for path in kept:
        print(f"kept: {path} (no build makes it)")
    return OK
