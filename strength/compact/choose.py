"""Chooses the fewest and smallest cases that keep the strength of all. Pure.

Weighted set multi-cover. Greedy, taking what meets most demands for its weight, is within a factor
of H(d) of the best choice, d being the most demands that one case meets. Afterwards, cases that
are not needed are dropped, and each heavy case is exchanged for others if those weigh less.
Source: Dobson: Worst-case analysis of greedy heuristics for integer programming with nonnegative
data, Mathematics of Operations Research 7 (1982).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from judge.problem.declaration import Problem
from judge.problem.manifest import Entry
from judge.problem.verdict import Verdict
from strength.analysis import FEWEST_KILLS
from strength.order import SAMPLE, START_BYTES
from strength.table import Matrix, Row

FEWEST_SLOW = 2  # cases that stop a slow submission: they are large, and luck passes none
# What a program that nobody has thought of may fail on. Each group keeps a case that has at least
# this share of the most of each.
EXTREMES: tuple[tuple[Callable[[Entry], int], float], ...] = (
    (lambda entry: entry.scenarios, 0.99),
    (lambda entry: entry.vertices, 0.99),
    (lambda entry: entry.pair_sum, 0.5),  # time is proportional to it: half is still too slow
)


@dataclass(frozen=True, slots=True)
class Demand:
    """At least `need` of these cases must be chosen. submission: whose kills they are, or ""."""

    cases: frozenset[str]
    need: int
    submission: str = ""


def choose(
    matrix: Matrix, problem: Problem, entries: Mapping[str, Entry], seconds: Mapping[str, float]
) -> dict[str, tuple[str, ...]]:
    """Return the names of the chosen cases by group, in the order of the matrix.

    Every sample is kept, for the statement shows it. entries: of all cases by name. seconds: the
    reference's CPU time on each.
    """
    chosen: dict[str, tuple[str, ...]] = {}
    for group in dict.fromkeys(case.group for case in matrix.cases):
        names = [case.name for case in matrix.cases if case.group == group]
        if group == SAMPLE:
            chosen[group] = tuple(names)
            continue
        weights = {name: _weight(entries[name], seconds[name]) for name in names}
        demands = [*kills(matrix, problem, group), *_extremes(names, entries)]
        kept = cover(demands, weights)
        chosen[group] = tuple(name for name in names if name in kept)
    return chosen


def kills(matrix: Matrix, problem: Problem, group: str) -> Iterator[Demand]:
    """Yield, for each submission that fails in a group, the cases that must kill it.

    Only declared verdicts count: a wrong program must not become merely slow.
    """
    for row in matrix.rows:
        killers = declared_kills(row, matrix, problem, group)
        if killers:
            need = min(wanted(problem, row.submission, group), len(killers))
            yield Demand(killers, need, row.submission)


def wanted(problem: Problem, submission: str, group: str) -> int:
    """Return how many cases of a group should kill a submission: fewer if it is only slow."""
    slow = problem.expected(submission, group) == {Verdict.TLE}
    return FEWEST_SLOW if slow else FEWEST_KILLS


def declared_kills(row: Row, matrix: Matrix, problem: Problem, group: str) -> frozenset[str]:
    """Return the cases of a group on which a submission gets a declared verdict other than AC."""
    declared = problem.expected(row.submission, group) - {Verdict.AC}
    names = (case.name for case in matrix.cases if case.group == group)
    return frozenset(name for name in names if row.verdicts.get(name) in declared)


def cover(demands: Sequence[Demand], weights: Mapping[str, int]) -> set[str]:
    """Return the names of few and light cases that meet every demand.

    The demands must be possible. O(cases^3 * demands) at worst; a second in practice.
    """

    def weight(names: set[str]) -> int:
        return sum(weights[name] for name in names)

    chosen = _without_needless(_completed(set(), demands, weights, without=""), demands, weights)
    for name in sorted(chosen, key=lambda name: -weights[name]):
        if any(name in demand.cases and len(demand.cases) <= demand.need for demand in demands):
            continue  # it has to stay
        other = _completed(chosen - {name}, demands, weights, without=name)
        other = _without_needless(other, demands, weights)
        if weight(other) < weight(chosen):
            chosen = other
    return chosen


def _completed(
    names: set[str], demands: Sequence[Demand], weights: Mapping[str, int], *, without: str
) -> set[str]:
    """Add cases, but for one, until every demand is met."""
    chosen = set(names)
    while left := [d for d in demands if len(d.cases & chosen) < d.need]:

        def worth(name: str, left: Sequence[Demand] = left) -> float:
            return sum(name in demand.cases for demand in left) / weights[name]

        chosen.add(max((n for n in weights if n not in chosen and n != without), key=worth))
    return chosen


def _without_needless(
    chosen: set[str], demands: Sequence[Demand], weights: Mapping[str, int]
) -> set[str]:
    """Drop cases, heavy ones first, as long as every demand is met."""
    for name in sorted(chosen, key=lambda name: -weights[name]):
        rest = chosen - {name}
        if all(len(demand.cases & rest) >= demand.need for demand in demands):
            chosen = rest
    return chosen


def _weight(entry: Entry, seconds: float) -> int:
    """Return what a case costs: its bytes and its time, in bytes that take as long to read.

    Times are rounded, so that a second measurement gives the same choice.
    """
    centiseconds = max(1, round(100 * seconds))
    return entry.input.bytes + entry.answer.bytes + START_BYTES * centiseconds


def _extremes(names: Sequence[str], entries: Mapping[str, Entry]) -> Iterator[Demand]:
    for measure, share in EXTREMES:
        enough = share * max(measure(entries[name]) for name in names)
        yield Demand(frozenset(name for name in names if measure(entries[name]) >= enough), 1)
