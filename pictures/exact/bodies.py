"""A scenario's polygons with what is asked of them again and again, computed once."""

from __future__ import annotations

from functools import cached_property

from gen.geometry import Polygon
from gen.scenario import Box, Scenario
from pictures.exact.extremes import Extremes


class Bodies:
    """The robot and the obstacles of a scenario. Nothing is computed before it is asked for."""

    def __init__(self, scenario: Scenario) -> None:
        self.scenario = scenario
        self._known: dict[int, Extremes] = {}

    @cached_property
    def boxes(self) -> list[Box]:
        """The boxes of the obstacles. O(vertices)."""
        return [box(obstacle) for obstacle in self.scenario.obstacles]

    @cached_property
    def robot(self) -> Extremes:
        """The robot, to be asked for its extreme vertices."""
        return Extremes(self.scenario.robot)

    def obstacle(self, index: int) -> Extremes:
        """Return an obstacle, to be asked for its extreme vertices."""
        if index not in self._known:
            self._known[index] = Extremes(self.scenario.obstacles[index])
        return self._known[index]


def box(polygon: Polygon) -> Box:
    """Return (left, bottom, right, top)."""
    xs, ys = zip(*polygon, strict=True)
    return min(xs), min(ys), max(xs), max(ys)
