"""What `[feedback]` of problem.toml permits to tell: the rest is taken out of the results.

Every report shows results that went through here, and needs no rule of its own.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from pathlib import Path

from judge.explanation import Diagnosis, Slowness
from judge.problem.cases import Case
from judge.problem.declaration import Feedback
from judge.problem.verdict import Verdict
from judge.results import CaseResult, Judging

SECRET = "secret/"
# Their messages tell of the input, or are the program's own words, which may hold the input.
TELLING = (Verdict.WA, Verdict.RTE)


class Teller:
    """Takes out of the results of one judging, given in order, what may not be told."""

    def __init__(self, feedback: Feedback) -> None:
        self._feedback = feedback
        self._seen: Counter[str] = Counter()

    def result(self, result: CaseResult) -> CaseResult:
        """Return a result as it may be told.

        A secret case that may not be named is called after its place in its group:
        `secret/large/#3`.
        """
        self._seen[result.case.group] += 1
        named = self._feedback.name_secret_cases or not result.case.name.startswith(SECRET)
        if not named:
            parent = result.case.name.rpartition("/")[0]
            name = f"{parent}/#{self._seen[result.case.group]}"
            hidden = Case(name, result.case.group, Path(), Path())
            result = replace(result, case=hidden, withheld=True)
        if named and self._feedback.lessons:
            return result
        message = "" if result.verdict in TELLING else result.message
        return replace(result, message=message, mismatch=None, stderr="")


def told(judging: Judging, feedback: Feedback) -> Judging:
    """Return a judging as it may be told."""
    teller = Teller(feedback)
    groups = tuple(
        replace(group, cases=tuple(teller.result(result) for result in group.cases))
        for group in judging.groups
    )
    return replace(
        judging,
        groups=groups,
        slowness=_slowness(judging, feedback),
        diagnosis=_diagnosis(judging.diagnosis, feedback),
        counterexample=judging.counterexample if feedback.counterexample else None,
        unexplained=judging.unexplained if feedback.counterexample else "",
    )


def _diagnosis(found: Diagnosis | None, feedback: Feedback) -> Diagnosis | None:
    """Return what may be told of a diagnosis. A scene with its answers is a counterexample."""
    if found is None or not feedback.lessons:
        return None
    if feedback.counterexample:
        return found
    return replace(found, lessons=tuple(replace(each, scene=None) for each in found.lessons))


def _slowness(judging: Judging, feedback: Feedback) -> Slowness | None:
    """Return what may be told of a program that was too slow: the size of a case tells of it."""
    found = judging.slowness
    if found is None or not feedback.lessons:
        return None
    if feedback.name_secret_cases or found.size is None or not found.size.case.startswith(SECRET):
        return found
    return replace(found, size=None) if found.growths else None
