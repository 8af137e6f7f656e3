"""What a picture shows: a scenario, its decisive moment, and polygons with few enough corners."""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property

from gen.geometry import Point, Polygon, sweep
from gen.scenario import Box, Scenario
from pictures.exact.bodies import Bodies, box
from pictures.exact.extremes import Extremes
from pictures.exact.meeting import ExactPoint
from pictures.explain.thin import thinned
from pictures.moment import Approach, Contact

DIRECTIONS = 360  # of the corners that are drawn of a large polygon


@dataclass
class Matter:
    """A scenario and what was found out about it. `notes`: what is drawn in less detail."""

    bodies: Bodies
    moment: Contact | Approach | None
    notes: list[str] = field(default_factory=list)

    @property
    def scenario(self) -> Scenario:
        """What is to be explained."""
        return self.bodies.scenario

    @property
    def boxes(self) -> list[Box]:
        """The boxes of the obstacles."""
        return self.bodies.boxes

    @cached_property
    def robot(self) -> Polygon:
        """The robot at its start, with few corners."""
        return self._few("the robot", self.bodies.robot, self.moment.robot if self.moment else ())

    @cached_property
    def obstacle(self) -> Polygon:
        """The obstacle that decides, with few corners."""
        assert self.moment is not None
        index = self.moment.obstacle
        obstacle = self.bodies.obstacle(index)
        return self._few(f"obstacle {index + 1}", obstacle, self.moment.feature)

    @cached_property
    def covered(self) -> Polygon:
        """All that the robot covers on its way."""
        return sweep(self.robot, self.scenario.move).vertices

    @cached_property
    def covered_box(self) -> Box:
        """The box of all that the robot covers."""
        return box(self.covered)

    @property
    def moves(self) -> bool:
        """Whether the robot moves at all."""
        return self.scenario.move != (0, 0)

    @property
    def is_complete(self) -> bool:
        """Whether robot and deciding obstacle are drawn with all their corners."""
        assert self.moment is not None
        few = len(self.robot) + len(self.obstacle)
        obstacle = self.scenario.obstacles[self.moment.obstacle]
        return few == len(self.scenario.robot) + len(obstacle)

    @property
    def time(self) -> Fraction:
        """The decisive time; 0 without obstacles."""
        return self.moment.time if self.moment else Fraction(0)

    def robot_at(self, time: Fraction) -> list[ExactPoint]:
        """Return the robot at a time of its move."""
        dx, dy = self.scenario.move
        return [(x + time * dx, y + time * dy) for x, y in self.robot]

    def _few(self, name: str, extremes: Extremes, keep: tuple[Point, ...]) -> Polygon:
        few, every = thinned(extremes, DIRECTIONS, keep), len(extremes.polygon)
        if len(few) < every:
            self.notes.append(f"{name} has {len(few):,} of its {every:,} corners")
        return few

    def ends(self) -> tuple[ExactPoint, ExactPoint] | None:
        """Return the decisive points: the robot's at the decisive time, and the obstacle's."""
        if isinstance(self.moment, Approach):
            return self.moment.robot_point, self.moment.point
        return (self.moment.point, self.moment.point) if self.moment else None
