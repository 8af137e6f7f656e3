"""The kit itself as part of a package: what a judging needs, below `kit/`.

Large inputs are left out; `kit/prepare.sh` makes them from their seeds, where the package is used.
Their answers are in the package.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import msgspec

from export.files import Files
from export.package import ExportError, Package
from gen.added import ADDED
from gen.plan import HAND_MADE
from judge.kit.paths import DATA, ROOT
from judge.problem.cases import case_at
from judge.problem.manifest import MANIFEST, VERSION, Entry, Manifest
from judge.problem.order import ORDER

KIT = "kit/"
LARGE_BYTES = 100_000  # an input of a family that is larger is made from its seed
SUFFIXES = frozenset({".py", ".toml", ".json", ".html", ".css"})
ALWAYS = ("checker.py", "problem.toml", "pyproject.toml", "LICENSE", "tools/setup.py")
GALLERY = "data/gallery"


PREPARE = """\
#!/usr/bin/env bash
# Makes the kit's environment, and its large test cases from their seeds. PYTHON: 3.11 or newer.
set -euo pipefail
cd "$(dirname "$0")"
"${{PYTHON:-python3}}" tools/setup.py
.venv/bin/python -m gen build{cases}
"""


@dataclass(frozen=True, slots=True)
class Parts:
    """Which parts of the kit a package holds.

    rooms: folders with all of their code. files: single files besides `ALWAYS`. replaced: files
    whose text differs from the kit's own.
    """

    rooms: Sequence[str]
    files: Sequence[str]
    replaced: tuple[tuple[str, str], ...] = ()


def kit_files(package: Package, parts: Parts) -> Files:
    """Return these parts of the kit and the cases of a package, below `kit/`.

    Raises ExportError if a part is missing.
    """
    files, replaced = Files(), dict(parts.replaced)
    names = [*ALWAYS, *parts.files]
    for room in (*parts.rooms, GALLERY):
        names += sorted(_code(ROOT / room))
    for name in names:
        path = ROOT / name
        if not path.is_file():
            raise ExportError(f"{name}: this file of the kit is missing")
        executable = bool(path.stat().st_mode & 0o100)
        files.add(f"{KIT}{name}", replaced.pop(name, path), executable=executable)
    if replaced:
        raise ExportError(f"{min(replaced)}: is replaced, but not in the package")
    entries = _entries(package)
    for name, entry in entries.items():
        case = case_at(DATA, name)
        files.add(f"{KIT}data/{name}.ans", case.answer)
        if not _is_rebuilt(entry):
            files.add(f"{KIT}data/{name}.in", case.input)
    manifest = msgspec.json.format(msgspec.json.encode(Manifest(VERSION, entries)), indent=1)
    files.add(f"{KIT}data/{MANIFEST}", manifest + b"\n")
    files.add(f"{KIT}data/{ORDER}", DATA / ORDER)
    files.add(f"{KIT}prepare.sh", _prepare(package), executable=True)
    if (DATA / ADDED).is_file():
        files.add(f"{KIT}data/{ADDED}", DATA / ADDED)
    return files


def rebuilt(package: Package) -> list[str]:
    """Return the names of the cases whose inputs are left out."""
    return [name for name, entry in _entries(package).items() if _is_rebuilt(entry)]


def _prepare(package: Package) -> str:
    """Return the script that makes the environment and the inputs that are left out."""
    cases = [f"'{name}'" for name in rebuilt(package)] if package.compact else []
    return PREPARE.format(cases="".join(f" \\\n  {case}" for case in cases))


def _entries(package: Package) -> dict[str, Entry]:
    """Return the cases of a package, and the one that tells the speed of a machine.

    Raises ExportError for a case that is not in the manifest.
    """
    known = package.manifest.cases
    names = [case.name for group in package.groups for case in group.cases]
    names.append(package.problem.calibration.case)
    missing = next((name for name in names if name not in known), None)
    if missing is not None:
        raise ExportError(f"{missing}: not in the manifest; run 'make data'")
    return {name: known[name] for name in names}


def _is_rebuilt(entry: Entry) -> bool:
    """Tell whether an input is left out, because its seed makes it again."""
    return entry.family != HAND_MADE and entry.input.bytes > LARGE_BYTES


def _code(folder: Path) -> list[str]:
    """Return the names of the files of a room, from the kit's root."""
    found = (path for path in folder.rglob("*") if path.suffix in SUFFIXES)
    return [path.relative_to(ROOT).as_posix() for path in found]
