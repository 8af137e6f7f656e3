"""The decisive moment of a scenario: the first contact, or the closest approach. Exact."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from fractions import Fraction

from gen.geometry import Point
from gen.scenario import Scenario
from pictures.exact.bodies import Bodies
from pictures.exact.extremes import Extremes
from pictures.exact.meeting import ExactPoint, Feature, facing, overlap_witness
from pictures.exact.pair import Gap, Touch
from pictures.exact.pause import collector_paused
from pictures.exact.search import search
from pictures.exact.within import lies_within


class Kind(StrEnum):
    """What meets what: the robot's part first."""

    CORNER_CORNER = "corner meets corner"
    CORNER_EDGE = "corner meets edge"
    EDGE_CORNER = "edge meets corner"
    EDGE_EDGE = "edge meets edge"
    OVERLAP = "they overlap at the start"
    ROBOT_INSIDE = "the robot is inside the obstacle at the start"
    OBSTACLE_INSIDE = "the obstacle is inside the robot at the start"


_KINDS = {
    (1, 1): Kind.CORNER_CORNER,
    (1, 2): Kind.CORNER_EDGE,
    (2, 1): Kind.EDGE_CORNER,
    (2, 2): Kind.EDGE_EDGE,
}


@dataclass(frozen=True, slots=True)
class Contact:
    """The answer is NO: the first contact.

    obstacle: its index, the least of those that are touched first. time: 0 at the start of the
    move, 1 at its end. robot, feature: a corner (one vertex) or an edge (two) of the robot, where
    it is at the START, and of the obstacle; both empty if one is inside the other. point: common
    to both at that moment; in an edge's contact with an edge, the middle of what they share.
    """

    obstacle: int
    time: Fraction
    kind: Kind
    robot: Feature
    feature: Feature
    point: ExactPoint


@dataclass(frozen=True, slots=True)
class Approach:
    """The answer is YES: the closest approach to any obstacle, and its first moment.

    obstacle, time, kind, robot, feature: as in Contact. squared: the square of the distance.
    robot_point, point: the nearest points of the robot at that time, and of the obstacle.
    """

    obstacle: int
    time: Fraction
    kind: Kind
    robot: Feature
    feature: Feature
    squared: Fraction
    robot_point: ExactPoint
    point: ExactPoint


def decisive(scenario: Scenario, bodies: Bodies | None = None) -> Contact | Approach | None:
    """Return why the answer is what it is; None if there is no obstacle.

    bodies: of the scenario, if there are some already. Exact. O(m + n), and a few steps of
    O(log m + log n) for each obstacle near the way.
    """
    bodies = bodies or Bodies(scenario)
    with collector_paused():
        found = search(bodies)
    if found is None:
        return None
    if isinstance(found.event, Touch):
        return _contact(bodies, found.obstacle, found.event)
    return _approach(bodies, found.obstacle, found.event)


def _contact(bodies: Bodies, index: int, touch: Touch) -> Contact:
    scenario = bodies.scenario
    robot, obstacle = scenario.robot, scenario.obstacles[index]
    time, (dx, dy) = touch.time, scenario.move
    if touch.toward is not None:
        shift = time * dx, time * dy
        mine, its, _, point = facing(bodies.robot, bodies.obstacle(index), touch.toward, shift)
        return Contact(index, time, _KINDS[len(mine), len(its)], mine, its, point)
    if lies_within(robot, obstacle):
        return Contact(index, time, Kind.ROBOT_INSIDE, (), (), _exact(robot[0]))
    if lies_within(obstacle, robot):
        return Contact(index, time, Kind.OBSTACLE_INSIDE, (), (), _exact(obstacle[0]))
    mine, its, point = overlap_witness(robot, obstacle)
    return Contact(index, time, Kind.OVERLAP, mine, its, point)


def _approach(bodies: Bodies, index: int, gap: Gap) -> Approach:
    robot, obstacle, move = bodies.robot, bodies.obstacle(index), bodies.scenario.move
    (dx, dy), (wx, wy) = move, gap.toward
    pace = wx * dx + wy * dy
    time = Fraction(pace > 0)
    if pace == 0 and move != (0, 0):
        time = _first_opposite(robot, obstacle, gap.toward, move)
    mine, its, near, point = facing(robot, obstacle, gap.toward, (time * dx, time * dy))
    kind = _KINDS[len(mine), len(its)]
    return Approach(index, time, kind, mine, its, gap.squared, near, point)


def _first_opposite(robot: Extremes, obstacle: Extremes, toward: Point, move: Point) -> Fraction:
    """Return the first time at which the parts that face each other are opposite each other.

    The robot moves along them, across `toward`.
    """
    dx, dy = move
    mine = [dx * x + dy * y for x, y in robot.face(*toward)]
    its = [dx * x + dy * y for x, y in obstacle.face(-toward[0], -toward[1])]
    return Fraction(max(min(its) - max(mine), 0), dx * dx + dy * dy)


def _exact(point: Point) -> ExactPoint:
    return Fraction(point[0]), Fraction(point[1])
