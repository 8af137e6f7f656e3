"""The search for the first contact, or for the closest approach, among all obstacles."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

from gen.geometry import Polygon
from gen.scenario import Box
from pictures.exact.bodies import Bodies, box
from pictures.exact.pair import Gap, Touch, first_touch, gap
from pictures.exact.sieve import Sieve

SIEVE_FROM = 50  # obstacles near by: from so many on, a sieve pays


@dataclass(frozen=True, slots=True)
class Found:
    """The obstacle that decides, by its index, and what it does."""

    obstacle: int
    event: Touch | Gap


def search(bodies: Bodies) -> Found | None:
    """Return the first contact (a Touch), else the closest approach (a Gap); None: no obstacle.

    Of equal ones, the obstacle with the least index is named.
    Exact. O(m + n), and a few steps of O(log m + log n) for each obstacle that is not excluded by
    its box, or by one edge that keeps it away.
    """
    search = _Search(bodies)
    obstacles = bodies.scenario.obstacles
    for index, (obstacle, its_box) in enumerate(zip(obstacles, bodies.boxes, strict=True)):
        if not (search.best and search.is_far(obstacle, its_box)):
            search.look_at(index)
    return search.best


class _Search:
    def __init__(self, bodies: Bodies) -> None:
        self.move = bodies.scenario.move
        self.best: Found | None = None
        self._bodies = bodies
        self._box = box(bodies.scenario.robot)
        self._touched = False
        self._seen_near = 0
        self._latest = Fraction(1)  # a later contact does not matter
        self._squared = (0, 1)  # a wider gap does not matter; unused before the first one is known
        self._reach()

    @cached_property
    def _sieve(self) -> Sieve:
        return Sieve(self._bodies.robot, self.move)

    def look_at(self, index: int) -> None:
        """Take an obstacle into account."""
        robot, obstacle = self._bodies.robot, self._bodies.obstacle(index)
        if not self._touched:
            most = Fraction(*self._squared) if self.best else None
            near = gap(robot, obstacle, self.move, most)
            if near is None:
                return
            if near.squared > 0:
                self.best = Found(index, near)
                self._squared = near.squared.as_integer_ratio()
                return
        touch = first_touch(robot, obstacle, self.move, self._latest)
        if touch and (touch.time < self._latest or not self._touched):
            self.best = Found(index, touch)
            self._touched = True
            self._latest, self._squared = touch.time, (0, 1)
            self._reach()

    def _reach(self) -> None:
        """Compute the box of all that the robot covers up to the latest time that matters."""
        left, bottom, right, top = self._box
        dx, dy = (
            -(-abs(d) * self._latest.numerator // self._latest.denominator) for d in self.move
        )
        self._reach_box = (
            left - dx * (self.move[0] < 0),
            bottom - dy * (self.move[1] < 0),
            right + dx * (self.move[0] > 0),
            top + dy * (self.move[1] > 0),
        )

    def is_far(self, obstacle: Polygon, its_box: Box) -> bool:
        """Tell whether an obstacle certainly matters less than the best; False: perhaps not."""
        a, b, c, d = its_box
        left, bottom, right, top = self._reach_box
        x = a - right if a > right else left - c if c < left else 0
        y = b - top if b > top else bottom - d if d < bottom else 0
        most, whole = self._squared
        if (x or y) and (x * x + y * y) * whole >= most:
            return True
        self._seen_near += 1
        return self._seen_near > SIEVE_FROM and self._sieve.is_far(obstacle, self._squared)
