"""Finds what makes the program fail in a file that it fails on: one scenario, or a sequence."""

from __future__ import annotations

from dataclasses import dataclass

from judge.problem.verdict import Verdict
from stress.search.measure import measure
from stress.search.shrink import UnsteadyError
from stress.search.trial import Subject, Trial, shortest_failing_prefix

SUSPECTS = 6
REPEATS = 3


@dataclass(frozen=True, slots=True)
class Culprit:
    """A failing file: of one scenario, if that fails alone; else as short as its part is.

    alone: the file has one scenario.
    """

    trial: Trial

    @property
    def alone(self) -> bool:
        """Whether the last scenario needs none before it to fail."""
        return len(self.trial.scenarios) == 1


def culprit(subject: Subject, failed: Trial) -> Culprit:
    """Return the culprit in a file that failed. Raises UnsteadyError.

    If the program answers in step, the smallest wrongly answered scenarios are tried alone;
    otherwise the shortest failing beginning is found by bisection, and its last scenario
    tried. If none fails alone, it needs what comes before it.
    """
    if failed.in_step:
        ordered = sorted(failed.wrong, key=lambda index: measure(failed.scenarios[index]))
        suspects = list(dict.fromkeys([*ordered[:SUSPECTS], failed.wrong[0]]))
        beginning = failed.scenarios[: failed.wrong[0] + 1]
    else:
        shortest = shortest_failing_prefix(subject, failed.scenarios)
        if shortest is None:
            raise UnsteadyError
        beginning = shortest.scenarios
        suspects = [len(beginning) - 1]
    files = [failed.scenarios[index : index + 1] for index in suspects]
    alone = subject.first_failure(files)
    if alone is not None:
        _check_steady(subject, alone)
        return Culprit(alone)
    together = subject.trial(beginning)
    _check_steady(subject, together)
    return Culprit(together)


def _check_steady(subject: Subject, failed: Trial) -> None:
    """Raise UnsteadyError unless the file fails in the same way again and again."""
    repeats = 1 if failed.verdict is Verdict.TLE else REPEATS  # such a run takes long
    again = subject.trials([failed.scenarios] * repeats)
    if not failed.failed or any(trial.verdict is not failed.verdict for trial in again):
        raise UnsteadyError
