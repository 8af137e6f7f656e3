"""Seeds derived from what a case is, so that adding a case moves no other."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping

SALT = "collision-course-1"


def derive(family: str, parameters: Mapping[str, int | str], repeat: int) -> int:
    """Return the 64-bit seed of one case: the head of a SHA-256 over its description.

    `parameters` are all of the family's parameters, defaults filled in; their order
    does not matter.
    """
    text = json.dumps([SALT, family, sorted(parameters.items()), repeat], separators=(",", ":"))
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:8], "big")
