"""A cache shared by all commands: strings by kind and key, in one SQLite file.

Everything in it can be computed again, so its loss costs only time. A damaged file is
replaced. If no file can be written, nothing is kept after the process ends.
"""

from __future__ import annotations

import contextlib
import sqlite3
import threading
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Self

from judge.kit.paths import BUILD

STORE = BUILD / "store.sqlite"
BUSY_TIMEOUT_S = 10.0
KEYS_IN_ONE_QUERY = 500
SCHEMA = """
    CREATE TABLE IF NOT EXISTS kept (
        kind TEXT NOT NULL, key TEXT NOT NULL, value TEXT NOT NULL, PRIMARY KEY (kind, key)
    ) WITHOUT ROWID
"""


class Store:
    """Strings by kind and key. Any number of threads and processes may use one file at once."""

    def __init__(self, path: Path = STORE) -> None:
        self._lock = threading.Lock()
        self._connection = _open(path)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_error: object) -> None:
        self.close()

    def get(self, kind: str, keys: Iterable[str]) -> dict[str, str]:
        """Return the stored values of these keys; others are left out. O(keys * log(stored))."""
        wanted, found = list(keys), {}
        for start in range(0, len(wanted), KEYS_IN_ONE_QUERY):
            some = wanted[start : start + KEYS_IN_ONE_QUERY]
            marks = ",".join("?" * len(some))
            query = f"SELECT key, value FROM kept WHERE kind = ? AND key IN ({marks})"
            with self._lock, contextlib.suppress(sqlite3.Error):
                found.update(dict(self._connection.execute(query, [kind, *some])))
        return found

    def put(self, kind: str, values: Mapping[str, str]) -> None:
        """Store these values; they replace earlier values of the same keys."""
        rows = [(kind, key, value) for key, value in values.items()]
        with self._lock, contextlib.suppress(sqlite3.Error), self._connection:
            self._connection.executemany("INSERT OR REPLACE INTO kept VALUES (?, ?, ?)", rows)

    def close(self) -> None:
        """Close the file; more than once does no harm."""
        with self._lock:
            self._connection.close()


def _open(path: Path) -> sqlite3.Connection:
    """Open the file. Replace a damaged one; if no file can be written, use memory."""
    for place in (path, path, ":memory:"):
        try:
            if place is path:
                path.parent.mkdir(parents=True, exist_ok=True)
            connection = sqlite3.connect(place, timeout=BUSY_TIMEOUT_S, check_same_thread=False)
            connection.execute("PRAGMA synchronous = OFF")  # a power failure may lose it: no harm
            connection.execute(SCHEMA)
            return connection
        except sqlite3.OperationalError:  # locked for long, read-only, no space: not damaged
            continue
        except sqlite3.DatabaseError:
            with contextlib.suppress(OSError):
                path.unlink()
        except OSError:
            continue
    raise AssertionError("SQLite cannot open a database in memory")
