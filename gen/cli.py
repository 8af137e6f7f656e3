"""The command line of the generators: list, make, build, check, case, remove."""

from __future__ import annotations

import argparse
import io
import sys
from collections.abc import Iterable, Mapping, Sequence
from fnmatch import fnmatchcase
from pathlib import Path

from gen.added import all_recipes, find_added, load_added, save_added
from gen.answers import answer_file
from gen.build import BuildError, build_cases, is_current, render_family
from gen.check import check_data, check_file
from gen.families import FAMILIES, Parameters, find
from gen.plan import HAND_MADE, NAME, NAME_FORM, Recipe
from gen.validator import InputError, UsageError, load_rules, validate
from judge.kit.checksums import Checksums
from judge.kit.command import Parser, add_jobs, complain, run
from judge.kit.errors import KitError
from judge.kit.files import write_whole
from judge.kit.paths import DATA, REFERENCE, ROOT
from judge.kit.processors import processors
from judge.kit.progress import progress_bar
from judge.kit.store import Store
from judge.problem.declaration import load
from judge.problem.manifest import MANIFEST, Entry, load_manifest, save_manifest

OK, NOT_OK = 0, 1
SHARE_OF_YES = (30, 70)  # per cent; outside, a constant answer is right too often
FEWEST_ANSWERS = 10  # fewer say nothing about a share


class CommandError(KitError):
    """The command makes no sense as given."""


def main(arguments: Sequence[str]) -> int:
    """Run one command; return the exit status: 0 ok, 1 not ok, 2 usage error."""

    def command() -> int:
        options = _parser().parse_args(arguments)
        try:
            status: int = options.command(options)
        except BuildError as error:
            complain(f"gen: {error}")
            return NOT_OK
        return status

    return run(
        "gen", command, (UsageError,), "interrupted; what was built stays, nothing is half-written"
    )


def _parser() -> argparse.ArgumentParser:
    parser = Parser(prog="python -m gen", description="Make and check test data.")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    listing = commands.add_parser("list", help="the families, their parameters, and all cases")
    _add_data(listing)
    listing.set_defaults(command=_list)

    make = commands.add_parser("make", help="print a valid file of a family")
    make.add_argument("family", metavar="FAMILY")
    _add_recipe(make)
    make.set_defaults(command=_make)

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
    _add_data(build)
    build.set_defaults(command=_build)

    check = commands.add_parser("check", help="validate files; without FILE: all of the data")
    check.add_argument("files", nargs="*", type=Path, metavar="FILE")
    check.add_argument("--group", help="hold the files to this group's promises too")
    add_jobs(check, processors(), "cases checked")
    _add_data(check)
    check.set_defaults(command=_check)

    case = commands.add_parser("case", help="add a test case of your own to the data")
    case.add_argument("family", nargs="?", metavar="FAMILY", help="the family that makes it")
    case.add_argument("--file", type=Path, help="an input written by hand, instead of a family")
    _add_recipe(case)
    case.add_argument("--group", required=True, help="the group it goes to")
    case.add_argument("--name", help="its name (default: the family's and the seed, or FILE's)")
    _add_data(case)
    case.set_defaults(command=_case)

    remove = commands.add_parser("remove", help="remove a test case that was added by 'case'")
    remove.add_argument("name", metavar="NAME", help="such as secret/small/contacts-7")
    _add_data(remove)
    remove.set_defaults(command=_remove)
    return parser


def _add_recipe(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--seed", type=int, help="any integer (default: 1)")
    parser.add_argument(
        "--set",
        action="extend",
        nargs="+",
        default=[],
        metavar="NAME=VALUE",
        help="parameters of the family",
    )


def _add_data(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--data", type=Path, default=DATA, help="the data directory")


def _parameters(settings: Iterable[str]) -> Parameters:
    parameters: dict[str, int | str] = {}
    for setting in settings:
        name, equals, value = setting.partition("=")
        if not equals:
            raise CommandError(f"--set: expected NAME=VALUE, found {setting!r}")
        if name in parameters:
            raise CommandError(f"--set: expected {name} once, found it again: {setting!r}")
        parameters[name] = value
    return parameters


def _seed(options: argparse.Namespace) -> int:
    return 1 if options.seed is None else options.seed


def _list(options: argparse.Namespace) -> int:
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


def _make(options: argparse.Namespace) -> int:
    content = render_family(options.family, _parameters(options.set), _seed(options))
    sys.stdout.buffer.write(content)
    sys.stdout.buffer.flush()
    scenarios = int(content[: content.index(b"\n")])
    answers = answer_file(REFERENCE, content, scenarios)
    _warn_of_share(f"family {options.family}", answers.count(b"YES"), answers.count(b"NO"))
    return OK


def _warn_of_share(name: str, yes: int, no: int) -> None:
    """Say so if so few or so many answers are YES that a constant answer is mostly right."""
    low, high = SHARE_OF_YES
    if yes + no >= FEWEST_ANSWERS and not low * (yes + no) <= 100 * yes <= high * (yes + no):
        constant = "YES" if yes > no else "NO"
        complain(
            f"gen: warning: {name}: {100 * yes // (yes + no)} % of {yes + no} answers are YES "
            f"(expected {low} to {high} %): a program that always says {constant} is mostly right"
        )


def _build(options: argparse.Namespace) -> int:
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
                _warn_of_share(name, entry.yes, entry.no)
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


def _check(options: argparse.Namespace) -> int:
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


def _case(options: argparse.Namespace) -> int:
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
    if content is not None and _is_ignored(recipe.group):
        complain(
            f"gen: warning: {recipe.case_name}: git ignores files of this group, and `make clean` "
            "deletes them: keep your own copy"
        )
    _warn_of_share(recipe.case_name, entry.yes, entry.no)
    return OK


def _generated(options: argparse.Namespace) -> Recipe:
    """Return the recipe of an added case of a family. Raises CommandError, FamilyError."""
    if options.family is None:
        raise CommandError("case: expected a FAMILY, or --file with an input written by hand")
    family, seed = find(options.family), _seed(options)
    name = options.name or f"{family.name.replace('_', '-')}-{seed}"
    if not NAME.fullmatch(name):
        too_long = "" if options.name else "; the seed is too long for one: give a name"
        raise CommandError(f"--name: expected {NAME_FORM}, found {name!r}{too_long}")
    parameters = family.resolve(_parameters(options.set))
    return Recipe(options.group, name, family.name, parameters, seed)


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


def _is_ignored(group: str) -> bool:
    """Tell whether the kit's .gitignore names the folder of a group."""
    try:
        lines = (ROOT / ".gitignore").read_text(encoding="utf-8").split()
    except OSError:
        return False
    return f"/data/secret/{group}/" in lines


def _remove(options: argparse.Namespace) -> int:
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
