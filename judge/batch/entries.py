"""The files of a class: what a directory or a zip holds, by name, without unpacking anything.

Everything here was named and made by others. No name is ever used to write a file, no link is
followed, and no more of a file is read than asked for.
"""

from __future__ import annotations

import lzma
import os
import stat
import struct
import zipfile
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path, PurePosixPath

from judge.kit.errors import KitError
from judge.languages.chosen import is_hidden

MOST_FILES = 200_000
ZIP_BEGINS = (b"PK\x03\x04", b"PK\x05\x06")  # a member; the end, if there are no members
LINK, SPECIAL = "expected a regular file, found a link", "expected a regular file, found a device"
OUTSIDE = "its name leads out of the archive"
# What Python's zipfile raises for what is damaged, encrypted or unknown. (NotImplementedError is
# a RuntimeError, and a name that is no UTF-8 a ValueError.)
ZIP_ERRORS = (
    zipfile.BadZipFile,
    zlib.error,
    lzma.LZMAError,
    struct.error,
    RuntimeError,
    ValueError,
    EOFError,
    OSError,
)


class ClassError(KitError):
    """The directory or zip cannot be read as the hand-ins of a class."""


class UnreadableError(KitError):
    """One file cannot be read."""


@dataclass(frozen=True, slots=True)
class Entry:
    """A file, or an empty directory, of a class.

    path: as in the directory or zip. fault: why it cannot be read, "" if it can. is_file: False
    for an empty directory. read: returns at most so many bytes from its beginning; raises
    UnreadableError.
    """

    path: PurePosixPath
    fault: str
    is_file: bool
    read: Callable[[int], bytes]


def is_class(path: Path) -> bool:
    """Tell whether a path is a directory or a zip, and so holds a whole class."""
    if path.is_dir():
        return True
    try:
        if not path.is_file():  # a pipe must not be read here
            return False
        with path.open("rb") as file:
            return file.read(4) in ZIP_BEGINS
    except OSError:
        return False


@contextmanager
def entries_of(path: Path) -> Iterator[list[Entry]]:
    """Yield the entries of a directory or zip, sorted; they can be read within the block.

    Hidden files, and what macOS adds to a zip, are left out. Raises ClassError.
    """
    if path.is_dir():
        yield _limited(path, _in_directory(path))
        return
    try:
        archive = zipfile.ZipFile(path)
    except PermissionError as error:
        raise ClassError(f"{path}: cannot be read: {error.strerror}") from None
    except ZIP_ERRORS as error:
        raise ClassError(f"{path}: expected a zip, found a damaged one: {error}") from None
    with archive:
        yield _limited(path, _in_zip(archive))


def _limited(path: Path, found: Iterator[Entry]) -> list[Entry]:
    entries: list[Entry] = []
    for entry in found:
        if len(entries) == MOST_FILES:
            raise ClassError(f"{path}: expected at most {MOST_FILES:,} files, found more")
        entries.append(entry)
    return sorted(entries, key=lambda entry: entry.path)


def _in_directory(root: Path) -> Iterator[Entry]:
    waiting = [root]
    while waiting:
        directory = waiting.pop()
        here = PurePosixPath(directory.relative_to(root).as_posix())
        try:
            children = [child for child in os.scandir(directory) if not is_hidden(child.name)]
        except OSError as error:
            if directory == root:
                raise ClassError(f"{root}: cannot be read: {error.strerror}") from None
            yield _without_content(here, f"cannot be read: {error.strerror}", is_file=True)
            continue
        if not children and directory != root:
            yield _without_content(here, "", is_file=False)
        for child in children:
            path = here / child.name
            if child.is_symlink():
                yield _without_content(path, LINK, is_file=True)
            elif child.is_dir():
                waiting.append(Path(child.path))
            elif child.is_file():
                yield Entry(path, "", True, partial(_read_file, Path(child.path)))
            else:
                yield _without_content(path, SPECIAL, is_file=True)


def _read_file(path: Path, most: int) -> bytes:
    """Return the beginning of a regular file; a link that took its place is not followed."""
    try:
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
        with os.fdopen(descriptor, "rb") as file:
            return file.read(most)
    except OSError as error:
        raise UnreadableError(f"cannot be read: {error.strerror}") from None


def _in_zip(archive: zipfile.ZipFile) -> Iterator[Entry]:
    members = archive.infolist()
    folders = {PurePosixPath(_name(member)).parent for member in members}
    inhabited = {above for folder in folders for above in (folder, *folder.parents)}
    for member in members:
        name = _name(member)
        path = PurePosixPath(name)
        if not path.parts or any(is_hidden(part) for part in path.parts if part != ".."):
            continue
        if path.is_absolute() or ".." in path.parts or ":" in path.parts[0][1:2]:
            yield _without_content(path, OUTSIDE, is_file=True)
        elif name.endswith("/"):
            if path not in inhabited:
                yield _without_content(path, "", is_file=False)
        elif stat.S_ISLNK(member.external_attr >> 16):
            yield _without_content(path, LINK, is_file=True)
        else:
            yield Entry(path, "", True, partial(_read_member, archive, member))


def _name(member: zipfile.ZipInfo) -> str:
    """Return the name of a member; some programs for Windows write backslashes."""
    return member.filename.replace("\\", "/") or "(no name)"


def _read_member(archive: zipfile.ZipFile, member: zipfile.ZipInfo, most: int) -> bytes:
    try:
        with archive.open(member) as file:
            return file.read(most)
    except ZIP_ERRORS as error:
        raise UnreadableError(f"cannot be read: {error}") from None


def _without_content(path: PurePosixPath, fault: str, *, is_file: bool) -> Entry:
    return Entry(path, fault, is_file, lambda _most: b"")
