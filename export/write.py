"""Writes packages: the named targets, each as a file or a directory."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from export.files import Files
from export.package import ExportError, Package
from export.target import Target
from export.targets import TARGETS
from judge.kit.progress import progress_bar
from judge.kit.text import did_you_mean

ALL = "all"
MIB = 1 << 20


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


def write(target: Target, package: Package, directory: Path) -> tuple[Path, int]:
    """Build one package and write it; return its place and its bytes. Raises KitError, OSError."""
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
    if target.max_bytes is not None and size > target.max_bytes:
        path.unlink()
        limit = f"{target.max_bytes / MIB:,.0f} MiB"
        raise ExportError(f"{path.name}: {size / MIB:,.1f} MiB; this judge takes at most {limit}")
    return path, size
