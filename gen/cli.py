"""The command line of the generators: list, make, build, check, case."""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Iterable
from fnmatch import fnmatchcase
from pathlib import Path

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn
from rich.table import Table

from gen import manifest
from gen.build import BuildError, build_cases, is_current, render_family
from gen.check import check_data, check_file
from gen.families import FAMILIES, FamilyError, Parameters, find
from gen.manifest import Entry, ManifestError
from gen.plan import USER_CASES, Case, PlanError, all_cases, user_case_entry
from gen.validator import UsageError, load_rules
from judge.kit.command import run
from judge.kit.errors import KitError
from judge.kit.files import write_whole
from judge.kit.paths import DATA
from judge.problem.declaration import SpecError, load

OK, NOT_OK = 0, 1
_NAME = re.compile(r"[a-z0-9][a-z0-9_-]{0,60}")


class CommandError(KitError):
    """The command makes no sense as given; one clear line."""


ERRORS = (CommandError, FamilyError, ManifestError, PlanError, SpecError, UsageError)


def main(arguments: list[str]) -> int:
    """Run one command; return the exit status: 0 ok, 1 not ok, 2 usage error."""
    options = _parser().parse_args(arguments)

    def command() -> int:
        try:
            status: int = options.command(options)
        except BuildError as error:
            print(f"gen: {error}", file=sys.stderr)
            return NOT_OK
        return status

    return run("gen", command, ERRORS, "interrupted; what was built stays, nothing is half-written")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m gen", description="Make and check test data.")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    listing = commands.add_parser("list", help="the families, their parameters, and the plan")
    listing.set_defaults(command=_list)

    make = commands.add_parser("make", help="print a valid file of a family")
    _add_family(make)
    make.set_defaults(command=_make)

    build = commands.add_parser("build", help="make what is missing or differs from the manifest")
    build.add_argument("globs", nargs="*", metavar="GLOB", help="cases, such as 'secret/many/*'")
    build.add_argument("--force", action="store_true", help="make what is current, too")
    build.add_argument("--update-manifest", action="store_true", help="accept new sums")
    _add_jobs(build)
    _add_data(build)
    build.set_defaults(command=_build)

    check = commands.add_parser("check", help="validate files; without FILE: all of the data")
    check.add_argument("files", nargs="*", type=Path, metavar="FILE")
    check.add_argument("--group", help="hold the files to this group's promises too")
    _add_data(check)
    check.set_defaults(command=_check)

    case = commands.add_parser("case", help="add a test case of your own to the data")
    _add_family(case)
    case.add_argument("--group", required=True, help="the group it goes to")
    case.add_argument("--name", help="its name (default: the family's and the seed)")
    _add_data(case)
    case.set_defaults(command=_case)
    return parser


def _add_family(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("family", metavar="FAMILY")
    parser.add_argument("--seed", type=int, default=1, help="any integer (default: 1)")
    parser.add_argument(
        "--set",
        action="extend",
        nargs="+",
        default=[],
        metavar="NAME=VALUE",
        help="parameters of the family",
    )


def _add_jobs(parser: argparse.ArgumentParser) -> None:
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    parser.add_argument("--jobs", type=int, default=cores or 1, help="processes (default: cores)")


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


def _list(options: argparse.Namespace) -> int:
    console = Console(soft_wrap=not sys.stdout.isatty())
    families = Table("family", "makes", "parameters")
    for family in FAMILIES.values():
        defaults = " ".join(f"{name}={value}" for name, value in family.defaults.items())
        families.add_row(family.name, family.summary, defaults)
    cases = Table("case", "family", "parameters", "repeat")
    for case in all_cases():
        given = " ".join(f"{name}={value}" for name, value in case.parameters.items())
        cases.add_row(case.path, case.family or "(hand-made)", given, str(case.repeat))
    console.print(families)
    console.print(cases)
    return OK


def _make(options: argparse.Namespace) -> int:
    content = render_family(options.family, _parameters(options.set), options.seed)
    sys.stdout.buffer.write(content)
    sys.stdout.buffer.flush()
    return OK


def _build(options: argparse.Namespace) -> int:
    if options.jobs < 1:
        raise CommandError(f"--jobs: expected at least 1, found {options.jobs}")
    cases = all_cases(options.data)
    chosen = _chosen(cases, options.globs)
    before = dict(manifest.load(options.data).cases)
    stale = [
        case
        for case in chosen
        if options.force or not is_current(options.data, case, before.get(case.path))
    ]
    built = _with_progress(
        options.data, stale, before, update=options.update_manifest, jobs=options.jobs
    )
    paths = [case.path for case in cases]
    unplanned = sorted(set(before) - set(paths))
    if options.update_manifest:
        known = before | built
        manifest.save(options.data, {path: known[path] for path in paths if path in known})
    elif unplanned:
        raise BuildError(
            f"{unplanned[0]}: in the manifest, but not in the plan; build with --update-manifest"
        )
    print(f"{len(built)} built, {len(chosen) - len(built)} were current, of {len(paths)} cases")
    return OK


def _chosen(cases: Iterable[Case], globs: list[str]) -> list[Case]:
    if not globs:
        return list(cases)
    for glob in globs:
        if not any(fnmatchcase(case.path, glob) for case in cases):
            raise CommandError(f"no case matches {glob!r}; `python -m gen list` shows them")
    return [case for case in cases if any(fnmatchcase(case.path, glob) for glob in globs)]


def _with_progress(
    data: Path, cases: list[Case], expected: dict[str, Entry], *, update: bool, jobs: int
) -> dict[str, Entry]:
    columns = (TextColumn("building"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    last = TextColumn("{task.fields[last]}")
    with Progress(*columns, last, console=Console(stderr=True)) as progress:
        task = progress.add_task("building", total=len(cases), last="")

        def done(case: Case) -> None:
            progress.update(task, advance=1, last=case.path)

        return build_cases(data, cases, expected, update=update, jobs=jobs, done=done)


def _check(options: argparse.Namespace) -> int:
    if options.files:
        rules = load_rules(options.group)
        faults = [fault for file in options.files for fault in check_file(file, rules)]
        checked = f"{len(options.files)} files"
    else:
        if options.group is not None:
            raise CommandError("--group: expected FILE with it; all of the data is held to its own")
        load()  # the whole declaration is held to its form, not only what the validator reads
        if not (options.data / manifest.FILE).is_file():
            raise CommandError(f"--data: expected a data directory, found {options.data}")
        cases = all_cases(options.data)
        faults = check_data(options.data, cases)
        checked = f"{len(cases)} cases"
    for fault in faults:
        print(fault, file=sys.stderr)
    if not faults:
        print(f"{checked}: valid")
    return NOT_OK if faults else OK


def _case(options: argparse.Namespace) -> int:
    data: Path = options.data
    load_rules(options.group)
    name = options.name or f"{options.family.replace('_', '-')}-{options.seed}"
    if not _NAME.fullmatch(name):
        form = "up to 61 small letters, digits and dashes"
        too_long = "" if options.name else "; the seed is too long for one: give a name"
        raise CommandError(f"--name: expected {form}, found {name!r}{too_long}")
    parameters = find(options.family).resolve(_parameters(options.set))
    case = Case(options.group, name, options.family, parameters, options.seed)
    if any(case.path == other.path for other in all_cases(data)):
        raise CommandError(f"{case.path}: is there already; choose another --name or --seed")
    entries = dict(manifest.load(data).cases)
    entries |= build_cases(data, [case], {}, update=True, jobs=1, done=lambda _: None)
    added = data / USER_CASES
    listed = added.read_text(encoding="utf-8") if added.exists() else _USER_CASES_HEAD
    write_whole(added, (listed + user_case_entry(case)).encode(), parents=True)
    manifest.save(data, entries)
    print(f"{case.path}: {entries[case.path].yes} YES, {entries[case.path].no} NO")
    return OK


_USER_CASES_HEAD = (
    "# Cases added with `python -m gen case`; every build makes them as the plan's own.\n"
)
