"""Files that the program fails on, the most promising first: where a search starts."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator, Sequence
from itertools import takewhile
from pathlib import Path

from gen.scenario import Scenario, parse
from gen.validator import InputError, load_rules, validate
from judge.kit.errors import KitError
from judge.problem.verdict import Verdict
from judge.results import CaseResult
from stress.running.clock import Clock
from stress.running.trial import Subject, Trial
from stress.search.draw import TINY_FILES, larger_files, tiny_files

Say = Callable[[str], None]

MOST_CASES = 3  # failing test cases to start from, if nothing tiny fails


class CaseError(KitError):
    """A failing test case cannot be read."""


def tiny(subject: Subject, seed: int) -> Iterator[Trial]:
    """Yield the trials of tiny random files that fail."""
    for file in tiny_files(seed):
        yield from _failures(subject, subject.trial(file))


def larger(subject: Subject, seed: int, clock: Clock, say: Say) -> Iterator[Trial]:
    """Yield the trials of larger random files that fail, until the time is over."""
    for trial in subject.trials(takewhile(lambda _file: not clock.is_over, larger_files(seed))):
        say(f"drawing: {subject.answered:,} scenarios answered correctly")
        yield from _failures(subject, trial)


def given(subject: Subject, cases: Sequence[CaseResult]) -> Iterator[Trial]:
    """Yield the trials of failing test cases, the smallest files first, that fail again.

    Up to the first wrong answer if it is known; that scenario alone if it fails alone.
    """
    for case in smallest(cases):
        scenarios = read(case.case.input)
        number = case.mismatch.scenario if case.mismatch is not None else len(scenarios)
        beginning = scenarios[:number]
        files = [beginning[-1:], beginning] if case.mismatch is not None else [beginning]
        failed = subject.first_failure(files)
        if failed is not None:
            yield failed


def smallest(cases: Sequence[CaseResult]) -> list[CaseResult]:
    """Return the failing cases with the smallest input files."""
    return sorted(cases, key=lambda case: case.case.input.stat().st_size)[:MOST_CASES]


def read(path: Path) -> list[Scenario]:
    """Return the scenarios of an input file. Raises CaseError if it is not a valid one."""
    content = path.read_bytes()
    try:
        validate(io.BytesIO(content), load_rules())
    except InputError as fault:
        raise CaseError(f"{path}:{fault.line}: {fault.reason}") from None
    return parse(content)


def _failures(subject: Subject, trial: Trial) -> Iterator[Trial]:
    """Yield a trial that failed; if the file is only long, the first part of it that fails."""
    file, size = trial.scenarios, TINY_FILES[0]
    if trial.verdict is Verdict.TLE and len(file) > size:
        parts = (file[start : start + size] for start in range(0, len(file), size))
        failed = subject.first_failure(parts)
        if failed is not None:
            yield failed
    elif trial.failed:
        yield trial
