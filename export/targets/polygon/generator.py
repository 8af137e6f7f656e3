"""The generator of a Polygon package: one file that holds the kit's own generator.

Polygon's interface takes a test of less than 1 MiB as text; a larger one needs a generator.
"""

from __future__ import annotations

import json
import zlib
from base64 import b85encode
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from export.package import Package
from export.targets.polygon.programs import rendered
from judge.kit.paths import DATA, ROOT
from judge.problem.cases import Case
from judge.problem.manifest import load_manifest

TEXT_BYTES = 1 << 20  # a test from this size on is generated
NAME, LANGUAGE = "generator", "python.3"
# What a family imports, directories or files.
SOURCES = (
    *("gen/families", "gen/geometry", "gen/shapes"),
    *("gen/__init__.py", "gen/rng.py", "gen/scenario.py"),
    *("judge/__init__.py", "judge/kit/__init__.py", "judge/kit/errors.py", "judge/kit/text.py"),
)
COLUMNS = 100

Recipe = Sequence[Any]  # family, parameters, repeat


def arguments(case: Case) -> str:
    """Return what the generator is called with to make a case: `large 01-largest`."""
    return f"{case.group} {case.input.stem}"


def recipes(package: Package) -> dict[str, Recipe]:
    """Return how the large cases are made, by the arguments for each.

    A large case that was written by hand has no recipe.
    """
    manifest = load_manifest(DATA)
    found: dict[str, Recipe] = {}
    for group in package.groups:
        for case in group.cases:
            entry = manifest.cases.get(case.name)
            if entry and entry.family and case.input.stat().st_size >= TEXT_BYTES:
                found[arguments(case)] = (entry.family, entry.parameters, entry.repeat)
    return found


def source(package: Package, chosen: Mapping[str, Recipe]) -> str:
    """Return the generator's source, one file on the standard library of Python 3.11."""
    modules = json.dumps(_modules(), sort_keys=True).encode()
    text = b85encode(zlib.compress(modules, 9)).decode()
    lines = (text[at : at + COLUMNS] for at in range(0, len(text), COLUMNS))
    return rendered(
        "generator.py.jinja",
        title=package.problem.name,
        recipes=chosen,
        modules="\n".join(lines),
    )


def _modules() -> dict[str, str]:
    """Return the sources that a family needs, by the name of the module."""
    paths: list[Path] = []
    for part in SOURCES:
        path = ROOT / part
        paths += path.rglob("*.py") if path.is_dir() else [path]
    return {_module_name(path): path.read_text(encoding="utf-8") for path in paths}


def _module_name(path: Path) -> str:
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts).removesuffix(".__init__")
