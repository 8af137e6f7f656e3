"""`data/manifest.json`: what every test case is, down to its SHA-256 sums."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path

import msgspec

from judge.kit.errors import KitError
from judge.kit.files import write_whole

FILE = "manifest.json"


class ManifestError(KitError):
    """The manifest cannot be used; one clear line."""


class FileSum(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The size and sum of one file."""

    bytes: int
    sha256: str


class Entry(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One test case: how it was made, its two files, and what they hold.

    seed: derived from family, parameters and repeat; 0 for a hand-made case.
    pair_sum: the sum of k * m over the scenarios.
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
    """All test cases by their path below data/."""

    version: int
    cases: dict[str, Entry]


def sum_of(content: bytes) -> FileSum:
    """Return the size and sum of a file's content."""
    return FileSum(len(content), hashlib.sha256(content).hexdigest())


def load(data: Path) -> Manifest:
    """Return the manifest of a data directory, an empty one if there is none."""
    path = data / FILE
    try:
        return msgspec.json.decode(path.read_bytes(), type=Manifest)
    except FileNotFoundError:
        return Manifest(1, {})
    except OSError as error:
        raise ManifestError(f"{path}: cannot be read: {error.strerror}") from None
    except msgspec.DecodeError as error:
        raise ManifestError(f"{path}: not a manifest: {error}") from None


def save(data: Path, cases: Mapping[str, Entry]) -> None:
    """Write the manifest; nothing half-written is ever seen."""
    text = msgspec.json.format(msgspec.json.encode(Manifest(1, dict(cases))), indent=1)
    write_whole(data / FILE, text + b"\n", parents=True)


def faults(data: Path, path: str, entry: Entry) -> list[str]:
    """Return what is wrong with the two files of a case, one line each; [] if nothing is."""
    found = []
    for ending, expected in ((".in", entry.input), (".ans", entry.answer)):
        file = data / f"{path}{ending}"
        try:
            actual = sum_of(file.read_bytes())
        except FileNotFoundError:
            found.append(f"{path}{ending}: missing")
        except OSError as error:
            found.append(f"{path}{ending}: cannot be read: {error.strerror}")
        else:
            if actual != expected:
                found.append(f"{path}{ending}: expected {_shown(expected)}, found {_shown(actual)}")
    return found


def _shown(file: FileSum) -> str:
    return f"{file.bytes} bytes with SHA-256 {file.sha256[:12]}..."
