"""Removes a directory whatever a program left in it."""

from __future__ import annotations

import contextlib
import os
import shutil
import subprocess


def remove(directory: str | os.PathLike[str]) -> None:
    """Remove `directory`, even if it holds closed or deeply nested directories.

    Only files of other users can be left; they are not reported.
    """
    with contextlib.suppress(RecursionError):
        shutil.rmtree(directory, ignore_errors=True)
    if os.path.lexists(directory):
        script = 'chmod -R u+rwx -- "$0"; rm -rf -- "$0"'
        command = ("/bin/sh", "-c", script, os.fspath(directory))
        subprocess.run(command, stderr=subprocess.DEVNULL, check=False)
