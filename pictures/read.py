"""Scenarios read from a file that a user names."""

from __future__ import annotations

from pathlib import Path

from gen.parse import parse
from gen.scenario import Scenario


class ReadError(Exception):
    """The file is no input file of this problem; the message says which and what to do."""


def read_scenarios(path: Path) -> list[Scenario]:
    """Return the scenarios of a file, in their order. O(size). Raises ReadError.

    Only what cannot be read at all is refused: what exactly is wrong with a file,
    the input validator says.
    """
    try:
        return parse(path.read_bytes())
    except OSError as error:
        raise ReadError(f"{path}: cannot be read: {error.strerror}") from None
    except (ValueError, StopIteration, RuntimeError):
        hint = f"python -m gen check {path}"
        raise ReadError(f"{path}: not a valid input file; to see why: {hint}") from None
