"""SHA-256 checksums of files. A file that has not changed is not read again."""

from __future__ import annotations

import hashlib
import os
import time
from pathlib import Path

from judge.kit.store import Store

KIND = "sha256"
# Two changes within one tick of the file system's clock leave the same time stamps, so the
# checksum of a file written just now is not kept. Source: git's documentation, "racy git".
SETTLED_AFTER_NS = 2_000_000_000


class Checksums:
    """Checksums, each kept with the path, size, inode and time stamps of its file.

    A user can reset the modification time of a file, but not the time of its last inode change,
    so every changed file is read again. store: where to keep checksums; None: nowhere.
    """

    def __init__(self, store: Store | None = None) -> None:
        self._store = store
        self._new: dict[str, str] = {}

    def sha256(self, path: Path) -> str:
        """Return the checksum of a file, in hexadecimal. Raises OSError."""
        key = os.path.abspath(path)  # noqa: PTH100 (resolve() would follow links)
        state = _state(path.stat())
        kept = self._store.get(KIND, [key]).get(key, "") if self._store is not None else ""
        kept_state, _, kept_sum = kept.rpartition(" ")
        if kept_state == state:
            return kept_sum
        with path.open("rb") as file:
            found = hashlib.file_digest(file, "sha256").hexdigest()
            after = os.fstat(file.fileno())
        if _state(after) == state and after.st_ctime_ns < time.time_ns() - SETTLED_AFTER_NS:
            self._new[key] = f"{state} {found}"
        return found

    def keep(self) -> None:
        """Write the checksums that were computed since the last call to the store."""
        if self._store is not None and self._new:
            self._store.put(KIND, self._new)
        self._new = {}


def _state(stat: os.stat_result) -> str:
    """Return a text that changes whenever the content of the file does."""
    figures = (stat.st_size, stat.st_dev, stat.st_ino, stat.st_mtime_ns, stat.st_ctime_ns)
    return " ".join(map(str, figures))
