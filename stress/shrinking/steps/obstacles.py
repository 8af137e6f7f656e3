"""Fewer obstacles."""

from __future__ import annotations

from collections.abc import Iterator

from gen.rng import Rng
from gen.scenario import Scenario
from stress.shrinking.steps.parts import parts


def fewer_obstacles(scenario: Scenario, _rng: Rng) -> Iterator[Scenario]:
    """Yield the scenario without obstacles, then with some of them."""
    obstacles = scenario.obstacles
    yield Scenario(scenario.robot, scenario.move, [])
    for kept in parts(len(obstacles)):
        yield Scenario(scenario.robot, scenario.move, [obstacles[i] for i in kept])
