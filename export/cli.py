"""Packages for other judges: `python -m export TARGET ...`, `python -m export list`."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from export.files import Files
from export.package import ExportError, Package, load_package
from export.target import Target
from export.targets import TARGETS
from judge.kit.command import run
from judge.kit.paths import BUILD
from judge.kit.progress import progress_bar
from judge.kit.text import did_you_mean

DONE = 0
MIB = 1 << 20
LIST, ALL = "list", "all"


def main(arguments: Sequence[str]) -> int:
    """Run the command line; return its exit status: 0 written, 2 not."""
    return run("export", lambda: _command(arguments))


def _command(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(
        prog="python -m export",
        description="Write packages that other judges import as they are.",
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
        write(target, packages[compact], options.output)
    return DONE


def chosen(names: Sequence[str]) -> list[Target]:
    """Return the named targets, each once. Raises ExportError for an unknown name."""
    if ALL in names:
        return list(TARGETS.values())
    for name in names:
        if name not in TARGETS:
            near = did_you_mean(name, TARGETS)
            known = ", ".join(TARGETS)
            raise ExportError(f"no target {name!r}{near}; expected one of {known}")
    return [TARGETS[name] for name in dict.fromkeys(names)]


def show_targets() -> int:
    """Print every target with its judge."""
    width = max(map(len, TARGETS))
    for target in TARGETS.values():
        print(f"{target.name:{width}}  {target.title}")
    return DONE


def write(target: Target, package: Package, directory: Path) -> Path:
    """Build one package and write it; print where it is and what to do with it."""
    path = directory / target.file_name
    with progress_bar(target.name) as bar:
        files: Files = target.build(package)
        bar.begin(files.size // MIB, f"{target.name} (MiB)")
        written = 0

        def done(count: int) -> None:
            nonlocal written
            bar.advance((written + count) // MIB - written // MIB)
            written += count

        if target.directory:
            files.write_directory(path, done)
        else:
            files.write_zip(path, done)
    size = files.size if target.directory else path.stat().st_size
    print(f"{path}: {size / MIB:,.1f} MiB, {len(files.entries):,} files")
    print(f"  {target.import_it}")
    return path
