"""What a kill matrix says: which cases kill each submission, and what each case is good for.

A case kills a submission that is not accepted on it. Pure: from verdicts and declarations to
findings.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from strength.table import Matrix, Row

FEWEST_KILLS = 3  # one case may be lost or changed, and another be passed by luck
# Not for slow submissions: after a group's first TLE, its other cases are not run.
NEEDS_MANY_KILLS = ("wrong_answer/",)


@dataclass(frozen=True, slots=True)
class GroupCell:
    """One submission in one group: how many cases ran and how many killed it, and its verdict."""

    ran: int
    killed: int
    verdict: Verdict
    expected: frozenset[Verdict]

    @property
    def as_declared(self) -> bool:
        """Whether the group's verdict is a declared one."""
        return self.verdict in self.expected


@dataclass(frozen=True, slots=True)
class Analysis:
    """The findings.

    cells: by submission and group. families: by submission, how many cases of each family
    kill it. only_killer: by case, the submissions that no other case kills; without TLE,
    since the cases after it were not run. only_in_group: the same within the case's group, as
    a group is all or nothing. needless: the cases whose kills are all repeated elsewhere in
    their group. faults: a line for each verdict that is not declared, and for each wrong
    submission that too few cases kill.
    """

    cells: Mapping[str, Mapping[str, GroupCell]]
    families: Mapping[str, Mapping[str, int]]
    only_killer: Mapping[str, tuple[str, ...]]
    only_in_group: Mapping[str, tuple[str, ...]]
    needless: tuple[str, ...]
    faults: tuple[str, ...]


def analyse(matrix: Matrix, problem: Problem, families: Mapping[str, str]) -> Analysis:
    """Return the findings. families: of each case by name. O(submissions * cases)."""
    groups = tuple(dict.fromkeys(case.group for case in matrix.cases))
    cells = {
        row.submission: {group: _cell(row, group, matrix, problem) for group in groups}
        for row in matrix.rows
    }
    killers = {row.submission: _killers(row) for row in matrix.rows}
    group_of = {case.name: case.group for case in matrix.cases}
    only_killer: dict[str, list[str]] = {}
    only_in_group: dict[str, list[str]] = {}
    for row in matrix.rows:
        names = killers[row.submission]
        in_group = Counter(group_of[name] for name in names)
        for name in names:
            if row.verdicts[name] is Verdict.TLE:
                continue  # the later cases of the group were not run
            if len(names) == 1:
                only_killer.setdefault(name, []).append(row.submission)
            if in_group[group_of[name]] == 1:
                only_in_group.setdefault(name, []).append(row.submission)
    complete = set(groups) == set(problem.group_names)
    return Analysis(
        cells=cells,
        families={
            submission: dict(Counter(families.get(name, "") for name in names).most_common())
            for submission, names in killers.items()
        },
        only_killer={name: tuple(found) for name, found in only_killer.items()},
        only_in_group={name: tuple(found) for name, found in only_in_group.items()},
        needless=tuple(
            case.name
            for case in matrix.cases
            if case.name not in only_in_group and not _slows(case.name, matrix)
        ),
        faults=tuple(_faults(cells, killers, complete=complete)),
    )


def _slows(case: str, matrix: Matrix) -> bool:
    """Tell whether a submission exceeds the time limit on the case."""
    return any(row.verdicts.get(case) is Verdict.TLE for row in matrix.rows)


def _killers(row: Row) -> list[str]:
    """Return the cases that kill a submission, in order."""
    return [name for name, verdict in row.verdicts.items() if verdict is not Verdict.AC]


def _cell(row: Row, group: str, matrix: Matrix, problem: Problem) -> GroupCell:
    names = [case.name for case in matrix.cases if case.group == group]
    verdicts = [row.verdicts[name] for name in names if name in row.verdicts]
    fallen = [verdict for verdict in verdicts if verdict is not Verdict.AC]
    verdict = fallen[0] if fallen else Verdict.AC
    return GroupCell(len(verdicts), len(fallen), verdict, problem.expected(row.submission, group))


def _faults(
    cells: Mapping[str, Mapping[str, GroupCell]],
    killers: Mapping[str, list[str]],
    *,
    complete: bool,
) -> list[str]:
    lines = []
    for submission, by_group in cells.items():
        for group, cell in by_group.items():
            if not cell.as_declared:
                expected = "|".join(sorted(cell.expected))
                lines.append(f"{submission}: {group}: expected {expected}, found {cell.verdict}")
        count = len(killers[submission])
        if complete and submission.startswith(NEEDS_MANY_KILLS) and count < FEWEST_KILLS:
            found = ", ".join(killers[submission]) or "none"
            lines.append(
                f"{submission}: expected at least {FEWEST_KILLS} cases that kill it, found {found}"
            )
    return lines
