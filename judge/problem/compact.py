"""A small selection of the test cases: `compact.json` in a data directory.

`python -m strength --compact` writes it from the kill matrix.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import msgspec

from judge.kit.errors import KitError
from judge.kit.files import write_whole
from judge.kit.text import did_you_mean
from judge.problem.cases import Case

COMPACT = "compact.json"
VERSION = 1
REWRITE = "'python -m strength --compact' chooses anew"


class CompactError(KitError):
    """The small selection of cases cannot be used."""


class _Compact(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    version: int
    groups: dict[str, list[str]]


def compact_cases(directory: Path, cases: Sequence[Case]) -> list[Case]:
    """Return the cases that `compact.json` names, in their given order.

    cases: all cases of the directory. The selection must name only these, each in its own group,
    and at least one in every group. O(n). Raises CompactError.
    """
    groups = _load(directory)
    path = directory / COMPACT
    group_of = {case.name: case.group for case in cases}
    for group, names in groups.items():
        for name in names:
            if name not in group_of:
                near = did_you_mean(name, group_of)
                raise CompactError(f"{path}: {name}: no such test case{near}; {REWRITE}")
            if group_of[name] != group:
                raise CompactError(f"{path}: {name}: is not in the group {group}; {REWRITE}")
    for group in dict.fromkeys(group_of.values()):
        if not groups.get(group):
            raise CompactError(f"{path}: group {group}: expected cases, found none; {REWRITE}")
    chosen = {name for names in groups.values() for name in names}
    return [case for case in cases if case.name in chosen]


def _load(directory: Path) -> dict[str, list[str]]:
    path = directory / COMPACT
    try:
        found = msgspec.json.decode(path.read_bytes(), type=_Compact)
    except FileNotFoundError:
        raise CompactError(f"{path}: no such file; {REWRITE}") from None
    except OSError as error:
        raise CompactError(f"{path}: cannot be read: {error.strerror}") from None
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise CompactError(f"{path}: not a selection of cases: {error}") from None
    if found.version != VERSION:
        raise CompactError(f"{path}: expected version {VERSION}, found {found.version}; {REWRITE}")
    return found.groups


def save_compact(directory: Path, groups: Mapping[str, Sequence[str]]) -> None:
    """Write `compact.json`, completely or not at all. groups: names by group. Raises OSError."""
    content = _Compact(VERSION, {group: list(names) for group, names in groups.items()})
    text = msgspec.json.format(msgspec.json.encode(content), indent=1)
    write_whole(directory / COMPACT, text + b"\n")
