"""Finds what makes the program fail in a file that it fails on: one scenario, or a sequence."""

from __future__ import annotations

from judge.problem.verdict import Verdict
from stress.running.trial import Subject, Trial, shortest_failing_prefix
from stress.shrinking.measure import measure
from stress.shrinking.single import UnsteadyError

SUSPECTS = 6
REPEATS = 3


def culprit(subject: Subject, failed: Trial) -> Trial:
    """Return the trial of the culprit in a file that failed. Raises UnsteadyError.

    If the program answers in step, the smallest wrongly answered scenarios are tried alone;
    otherwise the shortest failing beginning is found by bisection, and its last scenario
    tried. If none fails alone, that beginning is the culprit; if it does not fail either,
    the whole file is.
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
        return alone
    together = subject.trial(beginning)
    if not together.failed:
        together = failed  # what comes after it, or how many there are, matters as well
    _check_steady(subject, together)
    return together


def _check_steady(subject: Subject, failed: Trial) -> None:
    """Raise UnsteadyError unless the file fails in the same way again and again."""
    repeats = 1 if failed.verdict is Verdict.TLE else REPEATS  # such a run takes long
    for trial in subject.trials([failed.scenarios] * repeats):
        if (trial.verdict, trial.wrong) != (failed.verdict, failed.wrong):
            raise UnsteadyError
