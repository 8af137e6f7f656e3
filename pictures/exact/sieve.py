"""Tells quickly that an obstacle is far from a sweep, where one edge of either separates them.

Scenes with 100,000 obstacles near one large robot need it: it costs a tenth of a search.
"""

from __future__ import annotations

from array import array
from bisect import bisect_left

from gen.geometry import Point, Polygon, sweep
from pictures.exact.extremes import SMALL, Extremes

_Line = tuple[int, int, int, int]  # a point (x, y) and the way ahead


class _Chain:
    """The floor or the ceiling of a convex polygon, with growing x. Arrays: quick to look at."""

    def __init__(self, points: Polygon) -> None:
        self.xs = array("q", [x for x, _ in points])
        self.ys = array("q", [y for _, y in points])

    def edge_at(self, x: int) -> _Line | None:
        """Return the edge that spans x, as its left end and the way to the right one."""
        xs, ys = self.xs, self.ys
        at = bisect_left(xs, x)
        if not 0 < at < len(xs):
            return None
        ax, ay = xs[at - 1], ys[at - 1]
        return ax, ay, xs[at] - ax, ys[at] - ay


class Sieve:
    """The area that a robot covers on its move, ready for many questions. O(m) to make."""

    def __init__(self, robot: Extremes, move: Point) -> None:
        self._robot, self._move = robot, move
        covered = sweep(robot.polygon, move).vertices
        left, right = covered.index(min(covered)), covered.index(max(covered))
        turned = covered[left:] + covered[:left]
        split = (right - left) % len(covered)
        self._floor = _Chain(turned[: split + 1])
        self._ceiling = _Chain([*turned[split:], turned[0]][::-1])
        self._tests = [self._past_edge_of_robot, self._past_edge_of_obstacle]

    def is_far(self, obstacle: Polygon, squared: tuple[int, int]) -> bool:
        """Tell whether the obstacle is certainly apart, and no nearer than a distance.

        False: perhaps not. squared: the square of the distance, as numerator and denominator.
        Exact. O(log m) for a small obstacle; no answer is tried for a large one.
        """
        if len(obstacle) > SMALL:
            return False
        first, second = self._tests
        if first(obstacle, *squared):
            return True
        if second(obstacle, *squared):
            self._tests.reverse()  # obstacles near by are often alike
            return True
        return False

    def _past_edge_of_robot(self, obstacle: Polygon, most: int, whole: int) -> bool:
        """Tell whether the line through an edge of the sweep keeps the obstacle far.

        Which edge: the one below or above the first corner; then that of the nearest corner.
        """
        corner = obstacle[0]
        for _ in range(2):
            edge = self._edge_at(corner)
            if edge is None:
                return False
            ax, ay, ux, uy = edge
            levels = [uy * (x - ax) - ux * (y - ay) for x, y in obstacle]
            level = min(levels)
            if level > 0 and level * level * whole >= most * (ux * ux + uy * uy):
                return True
            nearest = obstacle[levels.index(level)]
            if nearest is corner:
                break
            corner = nearest
        return False

    def _edge_at(self, corner: Point) -> _Line | None:
        """Return the sweep's edge above or below a corner: a point of it, and the way ahead."""
        below = self._floor.edge_at(corner[0])
        if below is None:
            return None
        ax, ay, ux, uy = below
        if ux * (corner[1] - ay) < uy * (corner[0] - ax):
            return below
        above = self._ceiling.edge_at(corner[0])
        if above is None:
            return None
        ax, ay, ux, uy = above
        return ax, ay, -ux, -uy

    def _past_edge_of_obstacle(self, obstacle: Polygon, most: int, whole: int) -> bool:
        """Tell whether the line through an edge of the obstacle keeps everything covered far."""
        polygon, (dx, dy) = self._robot.polygon, self._move
        near_x, near_y = polygon[0]
        ax, ay = obstacle[-1]
        for bx, by in obstacle:
            ux, uy = bx - ax, by - ay
            if uy * (near_x - ax) > ux * (near_y - ay):
                x, y = polygon[self._robot.farthest(-uy, ux)]
                level = uy * (x - ax) - ux * (y - ay) + min(uy * dx - ux * dy, 0)
                if level > 0 and level * level * whole >= most * (ux * ux + uy * uy):
                    return True
            ax, ay = bx, by
        return False
