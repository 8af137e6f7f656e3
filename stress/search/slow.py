"""Programs over a limit of time or memory: does a small scenario suffice for that?"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gen.scenario import Scenario
from judge.results import CaseResult
from stress.search.start import read, smallest
from stress.search.trial import Subject, Trial

MOST_VERTICES = 40  # of what counts as a small scenario
MOST_SCENARIOS = 1_000


def slow_when_small(subject: Subject, cases: Sequence[CaseResult]) -> Iterator[Trial]:
    """Yield trials that failed, of the scenarios of failing cases, large ones thinned.

    A thinned scenario keeps few vertices of each polygon, and few obstacles.
    """
    for case in smallest(cases):
        scenarios = read(case.case.input)
        step = max(1, len(scenarios) // MOST_SCENARIOS)
        small = [_thinned(scenario) for scenario in scenarios[::step]]
        trial = subject.trial(small)
        if trial.failed:
            yield trial


def _thinned(scenario: Scenario) -> Scenario:
    """Return the scenario with few obstacles and vertices."""
    obstacles = scenario.obstacles[:: max(1, len(scenario.obstacles) // 3)][:3]
    polygons = [polygon[:: max(1, len(polygon) // 9)] for polygon in (scenario.robot, *obstacles)]
    return Scenario(polygons[0], scenario.move, polygons[1:])
