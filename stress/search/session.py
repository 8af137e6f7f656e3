"""One search as a user asks for it: with a seed, and perhaps with the result added to the data."""

from __future__ import annotations

import secrets
from dataclasses import replace

from judge.explanation import Counterexample
from judge.judging import UNEXPLAINED, Failure
from stress.search.add import AddError, add_to_data
from stress.search.search import search
from stress.search.trial import Subject

SEEDS = 1_000_000


def new_seed() -> int:
    """Return a seed that nobody chose."""
    return secrets.randbelow(SEEDS)


def explain(failure: Failure, seed: int | None, *, add: bool) -> Counterexample | str:
    """Return the counterexample for a judged submission; or why there is none, in words.

    seed: of an earlier search, to repeat it; None: a new one. add: also add it to data/.
    Raises KitError.
    """
    failures = [case for case in failure.cases if case.verdict not in (None, *UNEXPLAINED)]
    chosen = new_seed() if seed is None else seed
    subject = Subject(failure.attempts, failure.limits)
    result = search(subject, failures, seed=chosen, say=failure.say)
    found = result.counterexample
    if found is None:
        return f"{result.remark} (seed {chosen})"
    return with_addition(found, "") if add else found


def with_addition(found: Counterexample, group: str) -> Counterexample:
    """Add a counterexample to data/, and say so in it. group: empty for the smallest that fits."""
    if found.file is None:
        return found
    try:
        said = add_to_data(found.file, group)
    except AddError as error:  # the counterexample is shown all the same
        said = str(error)
    return replace(found, steps=(*found.steps, said))
