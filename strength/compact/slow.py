"""On which further cases slow submissions run, so that more than one case is known to stop them.

The kill matrix ends a group at its first TLE. To choose cases, that is not enough. The first one
is the same for most slow submissions, and a slow program that nobody has thought of may pass it.
Wrong submissions that are also slow fail on small cases, too.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from judge.problem.cases import Case
from judge.problem.data import Data
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from strength.compact.choose import wanted
from strength.table import Further

LARGE = 0.6  # of the most vertices in a group: where slow methods are slow
SMALL = 0.2  # where they are not


def further_runs(data: Data, problem: Problem) -> Further:
    """Return what runs after a first TLE: slow submissions on large cases, others on small ones.

    A slow submission is one of which the group expects TLE alone. Small files come first. Each
    stops when enough cases have given it a declared verdict.
    """
    entries = data.manifest.cases

    @cache
    def candidates(group: str, *, slow: bool) -> tuple[Case, ...]:
        cases = [case for case in data.chosen if case.group == group]
        vertices = {case.name: entries[case.name].vertices for case in cases}
        most = max(vertices.values())

        def fits(case: Case) -> bool:
            share = vertices[case.name] / most
            return share >= LARGE if slow else share <= SMALL

        fitting = filter(fits, cases)
        return tuple(sorted(fitting, key=lambda case: entries[case.name].input.bytes))

    def further(submission: str, group: str, verdicts: Mapping[str, Verdict]) -> Case | None:
        declared = problem.expected(submission, group) - {Verdict.AC}
        among = candidates(group, slow=declared == {Verdict.TLE})
        kills = sum(verdicts.get(case.name) in declared for case in among)
        if kills >= wanted(problem, submission, group):
            return None
        return next((case for case in among if case.name not in verdicts), None)

    return further
