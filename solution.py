#!/usr/bin/env python3
"""Collision Course, the reference solution: exact, standard library only.

The lesson (submissions/accepted/textbook.py spells it out): all that the robot
ever covers, the sweep S, is convex, and an obstacle Q touches it if and only if
the origin is in the Minkowski sum  Q + (-S),  boundary included. Walking all of
that sum for every obstacle costs O(k * m). Here, only the part of its boundary
that lies above or below the origin is looked for, by binary search.

Seen from below, a convex polygon is its *floor*: the chain of vertices from the
leftmost to the rightmost, with growing slopes. The floor of a sum is the two
floors merged by slope. So the edge of it that spans x = 0 is found without
merging: bisect the floor of Q; at each vertex q that is tried, the edge of -S
at x = -q.x is found by bisecting its x. Which of the two edges comes first in the
merge tells on which side of q to go on. One edge of Q remains; a bisection of the
slopes finds the vertex of -S at which it is merged.

The ceiling of a polygon is the floor of its reflection in the origin, so one
set of functions does for both.

Time: O(m + n1 + n2 + ...) for copying lists by slicing, which is fast, and for each
obstacle of n vertices O(log n * log m) steps of computation. Memory: O(M + N).
No sort: floors are found by rotating the given counter-clockwise order.
"""

import sys
from bisect import bisect_left
from functools import cached_property

# Slopes dy / dx are compared as floor(dy * 2**56 / dx). Two different slopes have
# different keys: with |dx| <= 2 * 10**8 they are 1 / (4 * 10**16) > 2**-56 apart.
SLOPE_BITS = 56


def main() -> None:
    numbers = list(map(int, sys.stdin.buffer.read().split()))
    answers = []
    at = 1
    for _ in range(numbers[0]):
        m, k, dx, dy = numbers[at : at + 4]
        at += 4
        end = at + 2 * m
        touches = Sweep(numbers[at:end:2], numbers[at + 1 : end : 2], dx, dy, k).touches
        at = end
        answer = "YES"
        for _ in range(k):
            end = at + 1 + 2 * numbers[at]
            # After the first collision, the other obstacles are only skipped.
            if answer == "YES" and touches(numbers[at + 1 : end : 2], numbers[at + 2 : end : 2]):
                answer = "NO"
            at = end
        answers.append(answer)
    print("\n".join(answers))


class Sweep:
    """All points that a robot (xs, ys) covers while it moves by (dx, dy).

    k: how many obstacles will be asked about.
    """

    def __init__(self, xs: list[int], ys: list[int], dx: int, dy: int, k: int) -> None:
        self.robot = xs, ys
        self.robot_left, self.robot_right = left, right = min(xs), max(xs)
        self.move = dx, dy
        self.k = k
        # A chord from one of the leftmost points of the sweep to one of the rightmost.
        low, high = ys[xs.index(left)], ys[xs.index(right)]
        if dx < 0:
            left, low = left + dx, low + dy
        else:
            right, high = right + dx, high + dy
        self.left, self.low, self.right, self.rise = left, low, right, high - low

    @cached_property
    def floor(self) -> "Floor":
        """The floor of the sweep."""
        xs, ys = self.robot
        low, high = floor_ends(xs, self.robot_left, self.robot_right)
        return swept_floor(chain(xs, low, high), chain(ys, low, high), *self.move, self.k)

    @cached_property
    def mirror_floor(self) -> "Floor":
        """The floor of the sweep's reflection in the origin."""
        xs, ys = self.robot
        low, high = floor_ends(xs, self.robot_right, self.robot_left)
        mirror_xs, mirror_ys = negated(chain(xs, low, high)), negated(chain(ys, low, high))
        dx, dy = self.move
        return swept_floor(mirror_xs, mirror_ys, -dx, -dy, self.k)

    def touches(self, xs: list[int], ys: list[int]) -> bool:
        """Does the obstacle (xs, ys) share a point with the sweep?"""
        left = min(xs)
        right = max(xs)
        if right < self.left or left > self.right:
            return False
        x = xs[0]
        if self.left <= x <= self.right:
            # Over the chord, this vertex is not below the sweep, so the obstacle is clear
            # only if it lies above; and under the chord, only if it lies below.
            over = (ys[0] - self.low) * (self.right - self.left) > self.rise * (x - self.left)
            if over:
                return not sum_is_above_origin(self.mirror_floor, 1, xs, ys, left, right)
            return not sum_is_above_origin(self.floor, -1, xs, ys, right, left)
        return not (
            sum_is_above_origin(self.mirror_floor, 1, xs, ys, left, right)
            or sum_is_above_origin(self.floor, -1, xs, ys, right, left)
        )


def sum_is_above_origin(
    floor: "Floor", sign: int, xs: list[int], ys: list[int], first: int, last: int
) -> bool:
    """Does the sum of two convex polygons lie strictly above the origin?

    One polygon is given by its floor. The other is sign * (xs, ys), counter-clockwise;
    its floor leads from the vertex with the x `first` to that with `last`, before the sign.
    The sum must have a point with x = 0.
    """
    low, high = floor_ends(xs, first, last)
    floor_xs, floor_ys = floor.xs, floor.ys

    # The edge of the sum's floor at x = 0 belongs between the vertices low and high.
    while high - low > 1:
        middle = (low + high) // 2
        x, y = sign * xs[middle], sign * ys[middle]
        i = bisect_left(floor_xs, -x)
        if i == 0:
            high = middle
        elif i == len(floor_xs):
            low = middle
        else:
            fx, fy = floor_xs[i - 1], floor_ys[i - 1]
            ux, uy = floor_xs[i] - fx, floor_ys[i] - fy
            if (sign * ys[middle + 1] - y) * ux < uy * (sign * xs[middle + 1] - x):
                low = middle
            elif (y - sign * ys[middle - 1]) * ux > uy * (x - sign * xs[middle - 1]):
                high = middle
            else:  # it is this edge (ux, uy), moved by this vertex
                return (y + fy) * ux > uy * (x + fx)

    # Only the edge from low to high is left: where does it go in the merge?
    x, y = sign * xs[low], sign * ys[low]
    next_x, next_y = sign * xs[high], sign * ys[high]
    ux, uy = next_x - x, next_y - y
    i = bisect_left(floor.slopes, (uy << SLOPE_BITS) // ux)
    fx = floor_xs[i]
    if -x < fx:  # behind the origin: an edge of the floor, moved by low, is above it
        pass
    elif -next_x > fx:  # before the origin: the same with high
        x, y = next_x, next_y
    else:
        return (y + floor_ys[i]) * ux > uy * (x + fx)
    i = bisect_left(floor_xs, -x, 1)
    fx, fy = floor_xs[i - 1], floor_ys[i - 1]
    return (y + fy) * (floor_xs[i] - fx) > (floor_ys[i] - fy) * (x + fx)


class Floor:
    """The lower chain of a convex polygon: growing xs, slopes that never fall.

    `slopes` holds the slope keys of the edges, each computed when it is looked at.
    """

    def __init__(self, xs: list[int], ys: list[int]) -> None:
        self.xs = xs
        self.ys = ys
        self.slopes: LazySlopes | list[int] = LazySlopes(xs, ys)

    def compute_slopes(self) -> None:
        """Compute all slopes now: worth it before many searches."""
        xs, ys = self.xs, self.ys
        self.slopes = [
            (next_y - y << SLOPE_BITS) // (next_x - x)
            for x, y, next_x, next_y in zip(xs, ys, xs[1:], ys[1:])
        ]


class LazySlopes:
    """A sequence of the slope keys of a chain's edges, each computed when asked for."""

    def __init__(self, xs: list[int], ys: list[int]) -> None:
        self.xs = xs
        self.ys = ys

    def __len__(self) -> int:
        return len(self.xs) - 1

    def __getitem__(self, i: int) -> int:
        xs, ys = self.xs, self.ys
        return (ys[i + 1] - ys[i] << SLOPE_BITS) // (xs[i + 1] - xs[i])


def swept_floor(xs: list[int], ys: list[int], dx: int, dy: int, k: int) -> Floor:
    """Return the floor of all that a polygon with the floor (xs, ys) covers on its move."""
    if dx == 0:
        floor = Floor(xs, [y + dy for y in ys] if dy < 0 else ys)
    else:
        # The move is one more edge, put in where its slope belongs: what is to the right
        # of it is taken at the end of the move, or, if the robot moves left, at the start.
        cut = bisect_left(LazySlopes(xs, ys), (dy << SLOPE_BITS) // dx)
        left_xs, left_ys, right_xs, right_ys = xs[: cut + 1], ys[: cut + 1], xs[cut:], ys[cut:]
        if dx > 0:
            right_xs, right_ys = [x + dx for x in right_xs], [y + dy for y in right_ys]
        else:
            left_xs, left_ys = [x + dx for x in left_xs], [y + dy for y in left_ys]
        floor = Floor(left_xs + right_xs, left_ys + right_ys)
    if 16 * k > len(floor.xs):  # enough searches to come to pay for it
        floor.compute_slopes()
    return floor


def floor_ends(xs: list[int], left: int, right: int) -> tuple[int, int]:
    """Return the indices of the floor's first and last vertex, -len(xs) <= low < high < len(xs).

    xs: the x of a polygon's vertices, counter-clockwise; left, right: the least and the
    greatest of them. With left and right exchanged: the ceiling.
    A chain that runs over the end of the list begins at a negative index.
    """
    low = xs.index(left)
    high = xs.index(right)
    if xs[low + 1 - len(xs)] == left:  # a vertical edge leads down to the floor
        low += 1
    if xs[high - 1] == right:  # a vertical edge leads up from it (high may become -1)
        high -= 1
    return (low, high) if low < high else (low - len(xs), high)


def chain(numbers: list[int], low: int, high: int) -> list[int]:
    """Return the numbers from index low to index high; low may be negative, high is not."""
    return numbers[low : high + 1] if low >= 0 else numbers[low:] + numbers[: high + 1]


def negated(numbers: list[int]) -> list[int]:
    return [-number for number in numbers]


if __name__ == "__main__":
    main()
