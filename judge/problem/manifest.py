"""Holds test cases to `manifest.json`, the sizes and sums of the files as they were built.

A directory without a manifest holds whatever it holds; so does a case that its
manifest does not name.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from pathlib import Path

import msgspec

from judge.problem.cases import REBUILD, Case, CasesError, group_of

MANIFEST = "manifest.json"


class FileSum(msgspec.Struct, frozen=True):
    """The size and SHA-256 sum (hexadecimal) of one file."""

    bytes: int
    sha256: str


class Entry(msgspec.Struct, frozen=True):
    """What the judge wants of an entry; how the case was made is the generators' business."""

    input: FileSum
    answer: FileSum


class Manifest(msgspec.Struct, frozen=True):
    """The entries by name of case."""

    cases: dict[str, Entry]


def load_manifest(directory: Path) -> Manifest:
    """Return the manifest of `directory`, an empty one if it has none. Raises CasesError."""
    path = directory / MANIFEST
    try:
        return msgspec.json.decode(path.read_bytes(), type=Manifest)
    except FileNotFoundError:
        return Manifest({})
    except OSError as error:
        raise CasesError(f"{path}: cannot be read: {error.strerror}") from None
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise CasesError(f"{path}: not a manifest: {error}") from None


def check_complete(manifest: Manifest, cases: Iterable[Case], groups: Iterable[str]) -> None:
    """Raise CasesError if a named case of one of `groups` is not among `cases`."""
    present, wanted = {case.name for case in cases}, set(groups)
    for name in manifest.cases:
        if name not in present and group_of(name) in wanted:
            raise CasesError(f"{name}: this test case is not built yet; {REBUILD}")


def check_sums(manifest: Manifest, cases: Iterable[Case]) -> None:
    """Raise CasesError for the first file that is not what was built. Reads every file once."""
    for case in cases:
        if entry := manifest.cases.get(case.name):
            _check_file(case.input, entry.input)
            _check_file(case.answer, entry.answer)


def _check_file(path: Path, expected: FileSum) -> None:
    try:
        size = path.stat().st_size
        if size != expected.bytes:
            raise CasesError(
                f"{path}: expected {expected.bytes} bytes, found {size}: "
                f"cut short or changed; {REBUILD}"
            )
        with path.open("rb") as file:
            found = hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as error:
        raise CasesError(f"{path}: cannot be read: {error.strerror}") from None
    if found != expected.sha256:
        raise CasesError(
            f"{path}: expected SHA-256 {expected.sha256[:12]}…, found {found[:12]}…: "
            f"changed; {REBUILD}"
        )
