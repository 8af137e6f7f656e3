"""Removes a directory whatever a program left in it."""

from __future__ import annotations

import os
import subprocess


def remove(directory: str | os.PathLike[str]) -> None:
    """Remove `directory`, even if it holds closed or deeply nested directories.

    Only files of other users can be left; they are not reported.
    """
    script = 'chmod -R u+rwx -- "$0"; rm -rf -- "$0"'
    subprocess.run(("/bin/sh", "-c", script, directory), stderr=subprocess.DEVNULL, check=False)
