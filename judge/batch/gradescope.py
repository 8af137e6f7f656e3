"""Reads the students' names from Gradescope's `submission_metadata.yml`.

The kit has no YAML library where it judges, and needs only the names: the lines that matter are
`submission_123:` without indentation, and below it `:submitters:` with `- :name: Ann Lee`. Lines
of any other form are skipped; a hand-in without a name is called by its folder.
"""

from __future__ import annotations

import json
import re

METADATA = "submission_metadata.yml"
MOST_BYTES = 1 << 26

_FOLDER = re.compile(r"(submission_\d+):\s*$")
_KEY = re.compile(r"  :?(\w+):")
_NAME = re.compile(r"  (?:- |  ):?name:\s*(\S.*?)\s*$")


def students(text: str) -> dict[str, str]:
    r"""Return the names of the submitters by folder, joined by commas.

    >>> students("submission_1:\n  :submitters:\n  - :name: Ann Lee\n    :sid: '7'\n")
    {'submission_1': 'Ann Lee'}
    """
    found: dict[str, list[str]] = {}
    folder, key = "", ""
    for line in text.splitlines():
        if match := _FOLDER.match(line):
            folder, key = match[1], ""
        elif match := _KEY.match(line):
            key = match[1]
        elif folder and key == "submitters" and (match := _NAME.match(line)):
            found.setdefault(folder, []).append(_plain(match[1]))
    return {folder: ", ".join(names) for folder, names in found.items()}


def _plain(scalar: str) -> str:
    """Return the text of a YAML scalar that stands on one line."""
    if scalar.startswith("'") and scalar.endswith("'"):
        return scalar[1:-1].replace("''", "'")
    if scalar.startswith('"'):
        try:
            return str(json.loads(scalar))
        except ValueError:
            return scalar.strip('"')
    return scalar
