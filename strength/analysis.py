"""What a kill matrix says: who falls where and how often, and what each case is good for.

Pure: from verdicts and declarations to findings.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass

from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from strength.table import Matrix, Row

FEWEST_KILLS = 3  # one case may be lost or changed, and luck may pass another
MUST_FALL_OFTEN = ("wrong_answer/",)  # a slow one is not run again after a group's first TLE


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

    cells: by submission and group. families: by submission, how many cases of each
    family kill it. only_killer: by case, the submissions that no other case kills (TLE
    aside, since it is not known what else would have).
    only_in_group: the same within the case's group (a group is worth all or nothing).
    needless: the cases that kill nothing that others of their group do not kill as well.
    faults: a line for everything that is not as it must be.
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
                continue  # nothing else of the group was run
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
        if complete and submission.startswith(MUST_FALL_OFTEN) and count < FEWEST_KILLS:
            found = ", ".join(killers[submission]) or "none"
            lines.append(
                f"{submission}: expected at least {FEWEST_KILLS} cases that kill it, found {found}"
            )
    return lines
