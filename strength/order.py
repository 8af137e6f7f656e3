"""The order in which judging is soonest done with a wrong program, computed from a kill matrix.

That is min-sum set cover: cases are sets of the submissions that they kill. Taking the case that
kills most of the remaining submissions for its cost is within a factor of 4 of the best order.
Source: Feige, Lovász, Tetali: Approximating min sum set cover, Algorithmica 40 (2004).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from judge.problem.verdict import Verdict
from strength.table import Matrix

# A run costs its start and its input: a Python program reads and solves so much while one starts.
START_BYTES = 150_000
SAMPLE = "sample"  # keeps the order of the statement


def telling_order(matrix: Matrix, input_bytes: Mapping[str, int]) -> list[str]:
    """Return the names of the secret cases, group by group, small and telling ones first.

    input_bytes: the size of each case's input file, by name. O(cases^2 * submissions) in a group.
    """
    kills = {
        case.name: {
            row.submission
            for row in matrix.rows
            if row.verdicts.get(case.name, Verdict.AC) is not Verdict.AC
        }
        for case in matrix.cases
    }
    groups = dict.fromkeys(case.group for case in matrix.cases if case.group != SAMPLE)
    order: list[str] = []
    for group in groups:
        names = [case.name for case in matrix.cases if case.group == group]
        order += _ordered(names, kills, input_bytes)
    return order


def _ordered(
    names: Sequence[str], kills: Mapping[str, set[str]], input_bytes: Mapping[str, int]
) -> Iterable[str]:
    """Order one group. When every submission is killed, all of them count again."""
    left, alive = list(names), set[str]()

    def worth(name: str) -> float:
        return len(kills[name] & alive) / (START_BYTES + input_bytes[name])

    while left:
        if not any(kills[name] & alive for name in left):
            alive = set().union(*(kills[name] for name in left))
        best = max(left, key=lambda name: (worth(name), -input_bytes[name]))
        yield best
        left.remove(best)
        alive -= kills[best]
