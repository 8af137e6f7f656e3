"""The front of checker.py: the judge's command line, with all that --explain adds to it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from judge import cli

if TYPE_CHECKING:
    from judge.explanation import Counterexample, Diagnosis, Growth
    from judge.judging import Failure, Search


def main(arguments: Sequence[str] | None = None) -> int:
    """Judge as the arguments say and return the exit status."""
    return cli.main(arguments, cli.Explainers(make_search, illustrate, measure))


# Each imports what it needs when it is called, so that a judging without --explain does not pay.


def make_search(seed: int | None, add: bool) -> Search:
    """Return the search that repeats a seed; None: a new one. add: put what it finds into data/."""

    def search(failure: Failure) -> Counterexample | str:
        from stress.search.session import explain

        return explain(failure, seed, add=add)

    return search


def illustrate(diagnosis: Diagnosis) -> Diagnosis:
    """Draw the scene of each missed lesson."""
    from stress.illustrate import illustrated

    return illustrated(diagnosis)


def measure(failure: Failure) -> tuple[Growth, ...]:
    """Return how the time of a program that was too slow grows. Raises KitError."""
    from stress.growth.measure import measure as climb

    return climb(failure.attempts, failure.limits, failure.say)
