"""Keeps the outcomes of a class, so that a judging goes on where a crash or Ctrl-C ended it.

An outcome is found only if nothing that it depends on has changed: the source and its language,
the names and the content of all chosen test cases, in order, the limits and the machine's scale,
what is run and told, and the kit's code that judges and diagnoses. JE is not kept.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path

import msgspec

from judge.batch.outcome import Outcome
from judge.batch.tasks import Task
from judge.judging import Options
from judge.kept import digest_of, judge_digest
from judge.kit.checksums import Checksums
from judge.kit.paths import DATA
from judge.kit.store import Store
from judge.languages.submission import Submission
from judge.problem.cases import Case
from judge.problem.data import Data
from judge.problem.declaration import Problem
from judge.problem.order import judging_order
from judge.problem.verdict import Verdict

KIND = "class"
NOT_PART = ("judge/kit/", "judge/calibrate/")
GALLERY = DATA / "gallery"


class KeptOutcomes:
    """The outcomes of all programs that are judged on the same data in the same way."""

    def __init__(self, store: Store, problem: Problem, options: Options, data: Data) -> None:
        self._store = store
        self._problem = problem
        self._options = options
        self._files = [
            *(path for case in judging_order(data.directory, data.chosen) for path in _files(case)),
            *sorted(GALLERY.rglob("*.*")),
        ]
        self._head = self._digest()

    def look_up(self, submissions: Mapping[str, Submission]) -> dict[str, Outcome]:
        """Return the outcomes that are kept, by the names that the submissions have here."""
        keys = {name: self._key(submission) for name, submission in submissions.items()}
        found = self._store.get(KIND, keys.values())
        outcomes = {name: _decoded(found.get(key, "")) for name, key in keys.items()}
        return {name: outcome for name, outcome in outcomes.items() if outcome is not None}

    def keep(self, task: Task, outcome: Outcome) -> None:
        """Keep an outcome, unless it is JE or the data was changed since the start."""
        if outcome.verdict is not Verdict.JE and self._digest() == self._head:
            text = msgspec.json.encode(outcome).decode()
            self._store.put(KIND, {self._key(task.submission): text})

    def _key(self, submission: Submission) -> str:
        source = hashlib.sha256(submission.source).hexdigest()
        return digest_of(self._head, source, submission.language.name)

    def _digest(self) -> str:
        """Return a digest of all that an outcome depends on besides the program."""
        options, problem = self._options, self._problem
        checksums = Checksums(self._store)
        files = [f"{path} {_checksum(checksums, path)}" for path in self._files]
        checksums.keep()
        declared = (problem.limits, problem.constraints, problem.groups, problem.feedback)
        scale = None if options.scale is None else options.scale.factor
        how = (options.time_limit_s, scale, options.stop_on_first, options.no_wall)
        return digest_of(*files, repr(declared), repr(how), judge_digest(NOT_PART))


def _files(case: Case) -> tuple[Path, Path]:
    return case.input, case.answer


def _checksum(checksums: Checksums, path: Path) -> str:
    try:
        return checksums.sha256(path)
    except OSError as error:  # judging will say more
        return str(error)


def _decoded(text: str) -> Outcome | None:
    try:
        return msgspec.json.decode(text, type=Outcome)
    except msgspec.DecodeError:  # nothing is kept, or it is damaged
        return None
