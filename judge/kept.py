"""Keeps verdicts, so that later commands need not run the same programs again.

A kept verdict is found only if nothing that it depends on has changed: the source, its
language, the declared limits, both files of the test case, and the judge's own code.
`checker.py` keeps its verdicts but always runs; `python -m strength` looks them up.
"""

from __future__ import annotations

import hashlib
import platform
from collections.abc import Iterable, Mapping
from functools import cache

from judge.kit.paths import ROOT
from judge.kit.store import Store
from judge.languages.submission import Submission
from judge.problem.cases import Case
from judge.problem.manifest import Entry, Manifest
from judge.problem.verdict import Verdict
from judge.sandbox.facts import RunLimits

KIND = "verdict"
NOT_PART_OF_JUDGING = ("judge/kit/", "judge/reports/", "judge/diagnosis/")


class KeptVerdicts:
    """The verdicts of one submission under the declared limits.

    Only verdicts on test cases of the manifest are kept, because it has their checksums.
    """

    def __init__(
        self, store: Store, submission: Submission, limits: RunLimits, manifest: Manifest
    ) -> None:
        self._store = store
        self._entries = manifest.cases
        self._head = digest_of(
            hashlib.sha256(submission.source).hexdigest(),
            submission.language.name,
            repr(limits),
            judge_digest(),
        )

    def look_up(self, cases: Iterable[Case]) -> dict[str, Verdict]:
        """Return the verdicts that are kept for these cases, by case name."""
        keys = {c.name: self._key(self._entries[c.name]) for c in cases if c.name in self._entries}
        found = self._store.get(KIND, keys.values())
        words = {name: found.get(key, "") for name, key in keys.items()}
        return {name: Verdict[word] for name, word in words.items() if word in Verdict.__members__}

    def keep(self, verdicts: Mapping[str, Verdict]) -> None:
        """Keep verdicts, given by case name. JE is not kept."""
        values = {
            self._key(self._entries[name]): verdict.value
            for name, verdict in verdicts.items()
            if verdict is not Verdict.JE and name in self._entries
        }
        if values:
            self._store.put(KIND, values)

    def _key(self, entry: Entry) -> str:
        return digest_of(self._head, entry.input.sha256, entry.answer.sha256)


@cache
def judge_digest(left_out: tuple[str, ...] = NOT_PART_OF_JUDGING) -> str:
    """Return a digest of the code that judges, and of the version of Python.

    left_out: folders of the kit whose code does not matter.
    """
    digest = hashlib.sha256(platform.python_version().encode())
    for path in sorted((ROOT / "judge").rglob("*")):
        name = path.relative_to(ROOT).as_posix()
        if path.suffix in (".py", ".toml") and not name.startswith(left_out):
            digest.update(f"\0{name}\0".encode() + path.read_bytes())
    return digest.hexdigest()


def digest_of(*parts: str) -> str:
    """Return a digest of texts that hold no zero byte."""
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()
