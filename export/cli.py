"""Packages for other judges: `python -m export TARGET ...`, `python -m export list`."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from export.package import Package, load_package
from export.targets import TARGETS
from export.verify import cli as verify
from export.write import ALL, MIB, chosen, write
from judge.kit.command import Parser, run
from judge.kit.paths import BUILD

DONE = 0
LIST, VERIFY, VERDICTS = "list", "verify", "verdicts"


def main(arguments: Sequence[str]) -> int:
    """Run the command line; return its exit status: 0 written, 2 not."""
    return run("export", lambda: _command(arguments))


def _command(arguments: Sequence[str]) -> int:
    if arguments[:1] == [VERIFY]:
        return verify.command(arguments[1:])
    if arguments[:1] == [VERDICTS]:
        return verify.verdicts(arguments[1:])
    parser = Parser(
        prog="python -m export",
        description="Write packages that other judges import as they are. "
        "Other commands: python -m export verify, python -m export verdicts.",
    )
    add = parser.add_argument
    add("target", nargs="+", help=f"what to write; '{LIST}' names the targets, '{ALL}' means all")
    add("--compact", action="store_true", help="only the cases of data/compact.json")
    add("--output", type=Path, default=BUILD / "export", metavar="DIR", help="(build/export)")
    options = parser.parse_args(arguments)
    if LIST in options.target:
        return show_targets()
    targets = chosen(options.target)
    packages: dict[bool, Package] = {}
    for target in targets:
        compact = options.compact or target.compact
        if compact not in packages:
            packages[compact] = load_package(compact=compact)
        path, size = write(target, packages[compact], options.output)
        print(f"{path}: {size / MIB:,.1f} MiB")
        print(f"  {target.import_it}")
    return DONE


def show_targets() -> int:
    """Print every target with its judge."""
    width = max(map(len, TARGETS))
    for target in TARGETS.values():
        print(f"{target.name:{width}}  {target.title}")
    return DONE
