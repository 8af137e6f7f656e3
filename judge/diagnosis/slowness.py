"""What is special about a test case that a program was too slow for: facts, no guess."""

from __future__ import annotations

from collections.abc import Sequence

from judge.explanation import Size
from judge.problem.cases import Case
from judge.problem.declaration import Problem
from judge.problem.manifest import Manifest
from judge.problem.scenarios import polygon_sizes
from judge.problem.verdict import Verdict
from judge.results import CaseResult


def first_timeout(results: Sequence[CaseResult]) -> CaseResult | None:
    """Return the first result with the verdict TLE, None if there is none."""
    return next((result for result in results if result.verdict is Verdict.TLE), None)


def size_of(case: Case, problem: Problem, manifest: Manifest) -> Size | None:
    """Return how large a test case is; None if it is no input of this problem. O(size)."""
    sizes = polygon_sizes(case.input)
    if not sizes:
        return None
    entry = manifest.cases.get(case.name)
    promises = {group.name: group.promise for group in problem.groups}
    return Size(
        case=case.name,
        family="" if entry is None else entry.family,
        promise=promises.get(case.group, ""),
        scenarios=len(sizes),
        robot=max(robot for robot, _ in sizes),
        obstacles=max(len(obstacles) for _, obstacles in sizes),
        obstacle=max((n for _, obstacles in sizes for n in obstacles), default=0),
        walks=sum(robot * len(obstacles) for robot, obstacles in sizes),
        pairs=sum(robot * sum(obstacles) for robot, obstacles in sizes),
    )
