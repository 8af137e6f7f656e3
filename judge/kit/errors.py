"""The base of every error that a user is told of."""

from __future__ import annotations


class KitError(Exception):
    """Something the user can act on; the message is one clear line: where, expected, found.

    Every command ends with that line and exit status 2, see `judge.kit.command`.
    """
