"""The order in which the cases of a group are judged: `order.json` in a data directory.

`python -m strength --order` writes it from the kill matrix. A directory without it is judged by
the names of its cases.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import msgspec

from judge.kit.errors import KitError
from judge.kit.files import write_whole
from judge.problem.cases import Case

ORDER = "order.json"
VERSION = 1


class OrderError(KitError):
    """The order of judging cannot be used."""


class _Order(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    version: int
    cases: list[str]


def judging_order(directory: Path, cases: Sequence[Case]) -> list[Case]:
    """Return the cases in the order of judging; groups stay in their order.

    In a group, the cases that `order.json` names come first, as it says; the others keep their
    order. Names of other cases are skipped. O(n log n). Raises OrderError.
    """
    places = {name: place for place, name in enumerate(_load(directory))}
    groups = list(dict.fromkeys(case.group for case in cases))
    return sorted(
        cases, key=lambda case: (groups.index(case.group), places.get(case.name, len(places)))
    )


def _load(directory: Path) -> list[str]:
    path = directory / ORDER
    try:
        return msgspec.json.decode(path.read_bytes(), type=_Order).cases
    except FileNotFoundError:
        return []
    except OSError as error:
        raise OrderError(f"{path}: cannot be read: {error.strerror}") from None
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        raise OrderError(f"{path}: not an order of cases: {error}") from None


def save_order(directory: Path, names: Sequence[str]) -> None:
    """Write `order.json`, completely or not at all. Raises OSError."""
    text = msgspec.json.format(msgspec.json.encode(_Order(VERSION, list(names))), indent=1)
    write_whole(directory / ORDER, text + b"\n")
