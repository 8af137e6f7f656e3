"""Writes files completely or not at all."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from judge.kit.errors import KitError
from judge.kit.paths import BUILD


class FileError(KitError):
    """A file cannot be written to the requested place."""


def write_whole(path: Path, data: bytes, *, parents: bool = False) -> None:
    """Write `data` to a temporary file beside `path`, then rename that file to `path`.

    A pipe or device is written to directly. A symbolic link is followed.
    parents: make missing directories.
    Raises OSError, with `path` as its file name.
    """
    target = path.resolve()
    try:
        if path.exists() and not path.is_file():
            path.write_bytes(data)  # /dev/stdout does not resolve to the name of a file
            return
        if parents:
            target.parent.mkdir(parents=True, exist_ok=True)
        _replace(target, data)
    except OSError as error:  # name the user's file, not the temporary one
        raise OSError(error.errno, error.strerror, str(path)) from None


def _replace(target: Path, data: bytes) -> None:
    with open_whole(target) as file:
        file.write(data)


@contextmanager
def open_whole(target: Path) -> Iterator[BinaryIO]:
    """Open a temporary file beside `target`; rename it to `target` when the block is done.

    If the block fails, the file is deleted and `target` stays as it was. Raises OSError.
    """
    handle, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}-")
    beside = Path(name)
    try:
        with os.fdopen(handle, "w+b") as file:
            yield file
        beside.chmod(0o644)
        beside.replace(target)
    except BaseException:
        beside.unlink(missing_ok=True)
        raise


def check_place(option: str, path: Path | None) -> None:
    """Raise FileError if a report cannot be written to `path`. To call before hours of work.

    option: the option that asked for the report. path None: no report was asked for.
    Every directory must exist, except build/, which `write_report` makes.
    """
    if path is None:
        return
    directory = path.absolute().parent
    if not directory.is_dir() and directory != BUILD:
        raise FileError(f"{option} {path}: no such directory")
    if path.is_dir():
        raise FileError(f"{option} {path}: expected a file, found a directory")


def write_report(option: str, path: Path | None, content: Callable[[], bytes]) -> None:
    """Write a report if one was asked for. Raises FileError."""
    if path is None:
        return
    try:
        write_whole(path, content(), parents=path.absolute().parent == BUILD)
    except OSError as error:
        raise FileError(f"{option} {path}: {error.strerror}") from None
