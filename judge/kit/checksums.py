"""SHA-256 sums of files, computed once for each state of a file."""

from __future__ import annotations

import hashlib
import os
import time
from pathlib import Path

from judge.kit.store import Store

KIND = "sha256"
# A file changed within one tick of the file system's clock keeps its time stamps, so what has
# just been written is not kept. Source: git's documentation of its index, "racy git".
SETTLED_AFTER_NS = 2_000_000_000


class Checksums:
    """The checksums of files, kept by path with size, inode and time stamps.

    The time of the last change of the inode cannot be set by a user, so a file that was
    changed and given its old time back is read again. store: where to keep them; None: nowhere.
    """

    def __init__(self, store: Store | None = None) -> None:
        self._store = store
        self._new: dict[str, str] = {}

    def sha256(self, path: Path) -> str:
        """Return the checksum of a file, in hexadecimal. Raises OSError."""
        key = os.path.abspath(path)  # noqa: PTH100 (a link is a file of its own here)
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
        """Keep what was computed since the last call."""
        if self._store is not None and self._new:
            self._store.put(KIND, self._new)
        self._new = {}


def _state(stat: os.stat_result) -> str:
    """Return what changes whenever the content of a file does."""
    figures = (stat.st_size, stat.st_dev, stat.st_ino, stat.st_mtime_ns, stat.st_ctime_ns)
    return " ".join(map(str, figures))
