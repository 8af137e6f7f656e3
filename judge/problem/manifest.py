"""The manifest of a data directory: how each test case was made, and the checksums of its files.

Nothing is checked in a directory without `manifest.json`, or for a case that the manifest
does not name.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path

import msgspec

from judge.kit.checksums import Checksums
from judge.kit.errors import KitError
from judge.kit.files import write_whole

MANIFEST = "manifest.json"
VERSION = 1


class ManifestError(KitError):
    """The manifest cannot be used."""


class FileSum(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The size and the SHA-256 checksum (hexadecimal) of one file."""

    bytes: int
    sha256: str


class Entry(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One test case: how it was made, its two files, and what they hold.

    family: empty for a hand-made case. seed: derived from family, parameters and repeat;
    0 for a hand-made case. pair_sum: the sum of k * m over the scenarios.
    """

    family: str
    parameters: dict[str, int | str]
    repeat: int
    seed: int
    input: FileSum
    answer: FileSum
    scenarios: int
    vertices: int
    pair_sum: int
    yes: int
    no: int


class Manifest(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """All test cases, by name."""

    version: int
    cases: dict[str, Entry]


def load_manifest(directory: Path) -> Manifest:
    """Return the manifest of `directory`, an empty one if it has none. Raises ManifestError."""
    path = directory / MANIFEST
    try:
        return msgspec.json.decode(path.read_bytes(), type=Manifest)
    except FileNotFoundError:
        return Manifest(VERSION, {})
    except OSError as error:
        raise ManifestError(f"{path}: cannot be read: {error.strerror}") from None
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise ManifestError(f"{path}: not a manifest: {error}") from None


def save_manifest(directory: Path, cases: Mapping[str, Entry]) -> None:
    """Write the manifest of `directory`, completely or not at all. Raises OSError."""
    text = msgspec.json.format(msgspec.json.encode(Manifest(VERSION, dict(cases))), indent=1)
    write_whole(directory / MANIFEST, text + b"\n", parents=True)


def sum_of(content: bytes) -> FileSum:
    """Return the size and checksum of a file's content."""
    return FileSum(len(content), hashlib.sha256(content).hexdigest())


def file_faults(
    directory: Path, name: str, entry: Entry, checksums: Checksums
) -> list[tuple[Path, str]]:
    """Return each file of the case `name` that differs from `entry`, and how."""
    stem = directory / name
    files = (
        (stem.with_name(f"{stem.name}.in"), entry.input),
        (stem.with_name(f"{stem.name}.ans"), entry.answer),
    )
    faults = ((path, _fault(path, expected, checksums)) for path, expected in files)
    return [(path, fault) for path, fault in faults if fault is not None]


def _fault(path: Path, expected: FileSum, checksums: Checksums) -> str | None:
    try:
        size = path.stat().st_size
        if size != expected.bytes:
            return f"expected {expected.bytes} bytes, found {size}: cut short or changed"
        found = checksums.sha256(path)
    except FileNotFoundError:
        return "missing"
    except OSError as error:
        return f"cannot be read: {error.strerror}"
    if found != expected.sha256:
        return f"expected SHA-256 {expected.sha256[:12]}…, found {found[:12]}…: changed"
    return None
