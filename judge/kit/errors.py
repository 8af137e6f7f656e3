"""The base class of all errors that are shown to the user."""

from __future__ import annotations


class KitError(Exception):
    """An error the user can act on. Its message is one line: where, expected, found.

    The command prints that line and exits with status 2, see `judge.kit.command`.
    """
