"""`gen build`: make what is missing or differs from the manifest."""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from fnmatch import fnmatchcase
from pathlib import Path

from gen.added import all_recipes
from gen.build import BuildError, build_cases, is_current
from gen.commands.common import OK, CommandError, Commands, add_data, warn_of_share
from gen.plan import Recipe
from judge.kit.checksums import Checksums
from judge.kit.command import add_jobs
from judge.kit.processors import processors
from judge.kit.progress import progress_bar
from judge.kit.store import Store
from judge.problem.manifest import Entry, load_manifest, save_manifest


def add(commands: Commands) -> None:
    """Add the command to the command line."""
    build = commands.add_parser("build", help="make what is missing or differs from the manifest")
    build.add_argument("globs", nargs="*", metavar="GLOB", help="cases, such as 'secret/many/*'")
    build.add_argument("--force", action="store_true", help="make what is current, too")
    build.add_argument(
        "--verify",
        action="store_true",
        help="make all, validate each input and confirm each answer by a second method, "
        "even where checksums are as in the manifest",
    )
    build.add_argument("--update-manifest", action="store_true", help="accept new checksums")
    add_jobs(build, processors(), "cases built")
    add_data(build)
    build.set_defaults(command=run)


def run(options: argparse.Namespace) -> int:
    """Build, and say how many cases were built. Raises KitError."""
    data: Path = options.data
    recipes = all_recipes(data)
    chosen = _chosen(recipes, options.globs)
    before = load_manifest(data).cases
    with Store() as store:
        checksums = Checksums(store)
        again = options.force or options.verify
        stale = [
            recipe
            for recipe in chosen
            if again or not is_current(data, recipe, before.get(recipe.case_name), checksums)
        ]
        built = _built(data, stale, before, options)
        for name in built:  # so that whoever judges need not
            for ending in (".in", ".ans"):
                checksums.sha256(data / f"{name}{ending}")
        checksums.keep()
    names = [recipe.case_name for recipe in recipes]
    unlisted = sorted(set(before) - set(names))
    if options.update_manifest:
        known = before | built
        save_manifest(data, {name: known[name] for name in names if name in known})
        for name, entry in built.items():
            if entry != before.get(name):
                warn_of_share(name, entry.yes, entry.no)
    elif unlisted:
        raise BuildError(
            f"{unlisted[0]}: in the manifest, but neither in the plan nor added; "
            "build with --update-manifest"
        )
    print(f"{len(built)} built, {len(chosen) - len(built)} were current, of {len(names)} cases")
    return OK


def _chosen(recipes: Sequence[Recipe], globs: Sequence[str]) -> list[Recipe]:
    for glob in globs:
        if not any(fnmatchcase(recipe.case_name, glob) for recipe in recipes):
            raise CommandError(f"no case matches {glob!r}; `python -m gen list` shows them")
    return [
        recipe
        for recipe in recipes
        if not globs or any(fnmatchcase(recipe.case_name, glob) for glob in globs)
    ]


def _built(
    data: Path, recipes: list[Recipe], expected: Mapping[str, Entry], options: argparse.Namespace
) -> dict[str, Entry]:
    if not recipes:
        return {}
    with progress_bar("building", len(recipes)) as bar:

        def done(recipe: Recipe) -> None:
            bar.say(f"built {recipe.case_name}")
            bar.advance()

        return build_cases(
            data,
            recipes,
            expected,
            update=options.update_manifest,
            verify=options.verify,
            jobs=options.jobs,
            done=done,
        )
