"""Verdicts kept from one command to the next, so that only what changed is judged again."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from functools import cache

from judge.kit.checksums import Checksums
from judge.kit.paths import ROOT
from judge.kit.store import Store
from judge.languages.submission import Submission
from judge.problem.cases import Case
from judge.problem.verdict import Verdict
from judge.sandbox.facts import RunLimits

KIND = "verdict"
JUDGE = ROOT / "judge"
_WORDS = frozenset(verdict.value for verdict in Verdict)
NO_VERDICT_DEPENDS_ON = (JUDGE / "reports", JUDGE / "kit")


class KeptVerdicts:
    """The verdicts of one submission by what they depend on.

    That is its source and language, the declared limits (on a slower machine the time limit
    is scaled, and means the same), both files of the case, and the judge's own code.
    """

    def __init__(self, store: Store, submission: Submission, limits: RunLimits) -> None:
        self._store = store
        self._checksums = Checksums(store)
        figures = (limits.time_limit_s, limits.memory_mib, limits.output_mib, limits.processes)
        parts = (
            _judge_digest(),
            submission.language.name,
            " ".join(map(str, figures)),
            hashlib.sha256(submission.source).hexdigest(),
        )
        self._prefix = "\n".join(parts)

    def look_up(self, cases: Sequence[Case]) -> dict[str, Verdict]:
        """Return what is kept for these cases, by their names. Raises OSError."""
        keys = {case.name: self._key(case) for case in cases}
        self._checksums.keep()
        kept = self._store.get(KIND, keys.values())
        words = {name: kept[key] for name, key in keys.items() if key in kept}
        return {name: Verdict(word) for name, word in words.items() if word in _WORDS}

    def keep(self, case: Case, verdict: Verdict) -> None:
        """Keep a verdict; a judge error says nothing about the submission, so it is not kept."""
        if verdict is not Verdict.JE:
            self._store.put(KIND, {self._key(case): verdict.value})

    def _key(self, case: Case) -> str:
        sums = [self._checksums.sha256(path) for path in (case.input, case.answer)]
        return hashlib.sha256("\n".join((self._prefix, *sums)).encode()).hexdigest()


@cache
def _judge_digest() -> str:
    """Return a checksum of all code that a verdict depends on."""
    digest = hashlib.sha256()
    for path in sorted(JUDGE.rglob("*")):
        apart = any(path.is_relative_to(directory) for directory in NO_VERDICT_DEPENDS_ON)
        if path.is_file() and path.suffix != ".pyc" and not apart:
            digest.update(f"{path.relative_to(JUDGE)}\n{path.stat().st_size}\n".encode())
            digest.update(path.read_bytes())
    return digest.hexdigest()
