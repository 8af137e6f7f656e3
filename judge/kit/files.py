"""Writes files that are either whole or not there."""

from __future__ import annotations

import os
import tempfile
from pathlib import Path


def write_whole(path: Path, data: bytes, *, parents: bool = False) -> None:
    """Write `data` beside `path` and rename it there: never half a file.

    What is no regular file, such as a pipe or a device, is written to as it is; of a
    symbolic link, the target is replaced.
    parents: make missing directories.
    Raises OSError, with `path` as its file name.
    """
    target = path.resolve()
    try:
        if path.exists() and not path.is_file():
            path.write_bytes(data)  # /dev/stdout resolves to a name that is no file's
            return
        if parents:
            target.parent.mkdir(parents=True, exist_ok=True)
        _replace(target, data)
    except OSError as error:  # not the name of a file that the user has never heard of
        raise OSError(error.errno, error.strerror, str(path)) from None


def _replace(target: Path, data: bytes) -> None:
    handle, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}-")
    beside = Path(name)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
        beside.chmod(0o644)
        beside.replace(target)
    except BaseException:
        beside.unlink(missing_ok=True)
        raise
