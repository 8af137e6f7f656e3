"""The files of a package, in memory or on disk; written as a zip or a directory, whole or not."""

from __future__ import annotations

import re
import shutil
import tempfile
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path

from judge.kit.errors import KitError
from judge.kit.files import open_whole

# The strictest rule of the judges: Kattis. Every part of a path keeps it.
NAME = re.compile(r"[a-zA-Z0-9_][a-zA-Z0-9_.-]*")
# These are hidden by their name because their judges look for them so.
HIDDEN = frozenset({".timelimit", ".github", ".gitignore", ".pdf"})
EPOCH = (1980, 1, 1, 0, 0, 0)  # the earliest time that a zip can hold: equal input, equal bytes
PLAIN, EXECUTABLE = 0o100644, 0o100755
LEVEL = 4  # of compression: 8 % larger than the usual 6, in a quarter of the time


class FilesError(KitError):
    """A file of a package has a bad name, or a package cannot be written."""


@dataclass(frozen=True, slots=True)
class Entry:
    """One file: its content, or the path of a file with it."""

    source: bytes | Path
    executable: bool = False

    @property
    def size(self) -> int:
        """The bytes of the content."""
        return len(self.source) if isinstance(self.source, bytes) else self.source.stat().st_size

    def read(self) -> bytes:
        """Return the content."""
        return self.source if isinstance(self.source, bytes) else self.source.read_bytes()


@dataclass(slots=True)
class Files:
    """A tree of files, by path. Each path is relative, with `/`, and safe for every judge."""

    entries: dict[str, Entry] = field(default_factory=dict)

    def add(self, name: str, source: bytes | str | Path, *, executable: bool = False) -> None:
        """Add a file. source: its bytes, its text, or the path of a file. Raises FilesError."""
        for part in name.split("/"):
            if part not in HIDDEN and not NAME.fullmatch(part):
                raise FilesError(f"{name}: expected names like [a-zA-Z0-9_.-]+, found {part!r}")
        if name in self.entries:
            raise FilesError(f"{name}: is in the package twice")
        content = source.encode() if isinstance(source, str) else source
        self.entries[name] = Entry(content, executable)

    def merge(self, other: Files, prefix: str = "") -> None:
        """Add all files of another tree below `prefix` (`data/`)."""
        for name, entry in other.entries.items():
            self.add(prefix + name, entry.source, executable=entry.executable)

    def __iter__(self) -> Iterator[tuple[str, Entry]]:
        """Yield name and entry, sorted by name."""
        return iter(sorted(self.entries.items()))

    @property
    def size(self) -> int:
        """The bytes of all files, before compression."""
        return sum(entry.size for entry in self.entries.values())

    def as_zip(self, done: Callable[[int], None] = lambda _bytes: None) -> bytes:
        """Return a small tree as the bytes of a zip. Equal trees give equal bytes."""
        stream = BytesIO()
        with zipfile.ZipFile(stream, "w") as archive:
            self._fill(archive, done)
        return stream.getvalue()

    def write_zip(self, path: Path, done: Callable[[int], None] = lambda _bytes: None) -> None:
        """Write a zip beside `path`, then rename it. done: called with the bytes of each file.

        Equal trees give equal bytes: sorted names, fixed times and modes. Raises OSError.
        """
        path.parent.mkdir(parents=True, exist_ok=True)
        with open_whole(path) as stream, zipfile.ZipFile(stream, "w") as archive:
            self._fill(archive, done)

    def _fill(self, archive: zipfile.ZipFile, done: Callable[[int], None]) -> None:
        for name, entry in self:
            info = zipfile.ZipInfo(name, EPOCH)
            info.create_system = 3  # Unix, so that modes are kept, whatever system writes
            info.external_attr = (EXECUTABLE if entry.executable else PLAIN) << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            content = entry.read()
            archive.writestr(info, content, compresslevel=LEVEL)
            done(len(content))

    def write_directory(
        self, path: Path, done: Callable[[int], None] = lambda _bytes: None
    ) -> None:
        """Write the tree beside `path`, then rename it; what was there is replaced.

        Raises OSError.
        """
        path.parent.mkdir(parents=True, exist_ok=True)
        beside = Path(tempfile.mkdtemp(dir=path.parent, prefix=f".{path.name}-"))
        try:
            for name, entry in self:
                target = beside / name
                target.parent.mkdir(parents=True, exist_ok=True)
                if isinstance(entry.source, bytes):
                    target.write_bytes(entry.source)
                else:
                    shutil.copyfile(entry.source, target)
                target.chmod((EXECUTABLE if entry.executable else PLAIN) & 0o777)
                done(entry.size)
            beside.chmod(0o755)
            if path.is_dir():
                old = Path(tempfile.mkdtemp(dir=path.parent, prefix=f".{path.name}-old-"))
                path.replace(old / path.name)
                beside.replace(path)
                shutil.rmtree(old)
            else:
                beside.replace(path)
        finally:
            shutil.rmtree(beside, ignore_errors=True)
