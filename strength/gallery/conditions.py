"""When a lesson can matter: a program that misses only it is right in all other scenes.

Lessons without a condition here, such as those about the merge of edges, can matter anywhere.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from gen.geometry import Point, Polygon, cross, hull, minus, primitive, sweep, translated
from gen.scenario import Scenario

BEYOND_16_BITS, BEYOND_20_BITS = 20_000, 1_000_000  # least |coordinate| of some vertex
END = Fraction(1)
SHORT_CONTACT = Fraction(1, 12)  # of the move


def conditions_of(scenario: Scenario) -> frozenset[str]:
    """Return the lessons whose condition a scenario meets. O(n^2 log n) for n vertices."""
    view = _View(scenario)
    met = {
        "no-obstacles": not view.obstacles,
        "every-obstacle": len(view.obstacles) > 1,
        "between-obstacles": view.free and len(view.obstacles) > 1 and not view.hull_is_free,
        "vertical-move": scenario.move[0] == 0 and not view.still,
        "standing-still": view.still,
        "on-the-way": view.every(lambda touch: touch.first > 0 and touch.last < 1),
        "every-moment": view.every(
            lambda touch: touch.first > 0 and touch.last < min(touch.first + SHORT_CONTACT, END)
        ),
        "bounding-shapes": (view.free and any(map(view.boxes_meet, view.obstacles)))
        or view.every(lambda touch: touch.boundary_only),
        "touch": view.every(lambda touch: touch.boundary_only),
        "touch-corners": view.every(lambda touch: touch.corners),
        "touch-at-start": view.every(lambda touch: touch.first == 0 and touch.starts_outside),
        "touch-at-end": view.every(lambda touch: touch.first == 1),
        "overlap-at-start": view.every(lambda touch: not touch.starts_outside),
        "robot-inside": view.every(lambda touch: touch.robot_inside),
        "ray-through-vertex": any(map(view.is_level_with, view.obstacles)),
        "obstacle-inside": view.every(lambda touch: touch.obstacle_inside),
        "edges-cross": view.every(lambda touch: touch.no_vertex_inside),
        "end-of-the-move": view.free and any(map(view.would_meet, view.obstacles)),
        "edge-along-move": not view.still and view.has_edge_along_move,
        "axes-of-both": view.free and bool(view.obstacles),
        "lowest-tie": any(map(_has_level_edge, (view.swept, *view.obstacles))),
        "parallel-edges": any(map(view.has_parallel_edges, view.obstacles)),
        "same-x": any(map(_has_vertical_edge, (view.swept, *view.obstacles))),
        "same-shape": any(map(view.is_like_robot, view.obstacles)),
        "products": view.reach > BEYOND_16_BITS,
        "start-value": view.reach > BEYOND_20_BITS,
        "exact": view.reach > BEYOND_20_BITS,
    }
    return frozenset(lesson for lesson, holds in met.items() if holds)


def obstacles_met(scenario: Scenario) -> int:
    """Return how many obstacles the robot touches on its move. O(n^2 log n) for n vertices."""
    return len(_View(scenario).touches)


@dataclass(frozen=True, slots=True)
class _Touch:
    """How the robot meets one obstacle: from and to which part of the move, and where.

    boundary_only: sweep and obstacle share no inner point. starts_outside: the same of the
    robot at its start. corners: a vertex of one is on the boundary of the other.
    no_vertex_inside: the sweep has no vertex in the obstacle, nor the reverse.
    """

    first: Fraction
    last: Fraction
    boundary_only: bool
    starts_outside: bool
    corners: bool
    robot_inside: bool
    obstacle_inside: bool
    no_vertex_inside: bool


class _View:
    """A scenario with what the conditions ask of it."""

    def __init__(self, scenario: Scenario) -> None:
        self.robot = scenario.robot
        self.move = scenario.move
        self.obstacles = scenario.obstacles
        self.still = scenario.move == (0, 0)
        self.goal = translated(scenario.robot, scenario.move)
        self.swept = sweep(scenario.robot, scenario.move).vertices
        points = [*self.robot, *self.goal, *(v for o in self.obstacles for v in o)]
        self.reach = max(max(map(abs, point)) for point in points)

    @cached_property
    def touches(self) -> list[_Touch]:
        """How the robot meets each obstacle that it meets."""
        found = [o for o in self.obstacles if _place(_difference(self.swept, o)) >= 0]
        return [self._touch(obstacle) for obstacle in found]

    @property
    def free(self) -> bool:
        """Whether the answer is YES."""
        return not self.touches

    @property
    def hull_is_free(self) -> bool:
        """Whether the robot would pass the hull of all obstacles."""
        everything = hull([vertex for obstacle in self.obstacles for vertex in obstacle])
        return _place(_difference(self.swept, everything)) < 0

    def every(self, holds: Callable[[_Touch], bool]) -> bool:
        """Tell whether the robot meets an obstacle, and meets all that it meets in this way."""
        return bool(self.touches) and all(map(holds, self.touches))

    def boxes_meet(self, obstacle: Polygon) -> bool:
        """Tell whether the boxes of sweep and obstacle share a point."""
        mine, others = zip(*self.swept, strict=True), zip(*obstacle, strict=True)
        return all(min(a) <= max(b) and min(b) <= max(a) for a, b in zip(mine, others, strict=True))

    def would_meet(self, obstacle: Polygon) -> bool:
        """Tell whether a robot that came from and went on forever would meet the obstacle."""
        return not self.still and _times(_difference(obstacle, self.robot), self.move) is not None

    def has_parallel_edges(self, obstacle: Polygon) -> bool:
        """Tell whether an edge of the sweep has the direction of one of the reflected obstacle."""
        reflected = [(-x, -y) for x, y in obstacle]
        return not _directions(self.swept).isdisjoint(_directions(reflected))

    @property
    def has_edge_along_move(self) -> bool:
        """Whether an edge of the robot is parallel to its move."""
        return any(cross(minus(b, a), self.move) == 0 for a, b in _edges(self.robot))

    def is_level_with(self, obstacle: Polygon) -> bool:
        """Tell whether a corner of the sweep has the same x or y as one of the obstacle."""
        mine, others = zip(*self.swept, strict=True), zip(*obstacle, strict=True)
        return any(not set(a).isdisjoint(b) for a, b in zip(mine, others, strict=True))

    def is_like_robot(self, obstacle: Polygon) -> bool:
        """Tell whether the obstacle is the robot at its start or end, or listed as it is."""
        at = set(obstacle) in (set(self.robot), set(self.goal))
        return at or _from_first(obstacle) == _from_first(self.robot)

    def _touch(self, obstacle: Polygon) -> _Touch:
        met = _difference(self.swept, obstacle)
        start = _place(_difference(self.robot, obstacle))
        always = None if self.still else _times(_difference(obstacle, self.robot), self.move)
        first, last = always or (Fraction(0), Fraction(0))
        robot_in = [_place(obstacle, vertex) >= 0 for vertex in self.swept]
        obstacle_in = [_place(self.swept, vertex) >= 0 for vertex in obstacle]
        return _Touch(
            first=max(first, Fraction(0)),
            last=min(last, Fraction(1)),
            boundary_only=_place(met) == 0,
            starts_outside=start <= 0,
            corners=any(_place(obstacle, vertex) == 0 for vertex in self.swept)
            or any(_place(self.swept, vertex) == 0 for vertex in obstacle),
            robot_inside=all(robot_in),
            obstacle_inside=all(obstacle_in),
            no_vertex_inside=not any(robot_in) and not any(obstacle_in),
        )


def _difference(p: Polygon, q: Polygon) -> Polygon:
    """Return the Minkowski difference of two convex polygons, the slow way."""
    return hull([minus(a, b) for a in p for b in q])


def _place(polygon: Polygon, point: Point = (0, 0)) -> int:
    """Return 1 if a point lies inside a convex polygon, 0 on its boundary, -1 outside."""
    sides = [cross(minus(b, a), minus(point, a)) for a, b in _edges(polygon)]
    return (min(sides) > 0) - (min(sides) < 0)


def _times(difference: Polygon, move: Point) -> tuple[Fraction, Fraction] | None:
    """Return the first and last t with t * move in a convex polygon; None if there is none."""
    firsts: list[Fraction] = []
    lasts: list[Fraction] = []
    for a, b in _edges(difference):
        edge = minus(b, a)
        speed, offset = cross(edge, move), cross(edge, a)  # inside: speed * t >= offset
        if speed == 0 and offset > 0:
            return None
        if speed > 0:
            firsts.append(Fraction(offset, speed))
        elif speed < 0:
            lasts.append(Fraction(offset, speed))
    first, last = max(firsts), min(lasts)
    return (first, last) if first <= last else None


def _edges(polygon: Polygon) -> Sequence[tuple[Point, Point]]:
    return list(zip(polygon, polygon[1:] + polygon[:1], strict=True))


def _directions(polygon: Polygon) -> set[Point]:
    return {primitive(minus(b, a)) for a, b in _edges(polygon)}


def _has_level_edge(polygon: Polygon) -> bool:
    return any(a[1] == b[1] for a, b in _edges(polygon))


def _has_vertical_edge(polygon: Polygon) -> bool:
    return any(a[0] == b[0] for a, b in _edges(polygon))


def _from_first(polygon: Polygon) -> Polygon:
    return [minus(vertex, polygon[0]) for vertex in polygon]
