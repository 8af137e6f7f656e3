"""Files with as many bytes as their vertices can have.

Attacks input buffers that were made for fewer digits.
"""

from __future__ import annotations

from collections.abc import Iterator

from gen.families.registry import Scenarios, family
from gen.geometry import sweep
from gen.geometry.contact import pair, random_support
from gen.rng import Rng
from gen.scenario import LIMIT, Scenario, bounds, fits, moved
from gen.shapes.convex import in_box


@family
def longest(rng: Rng, *, scenarios: Scenarios = 100) -> Iterator[Scenario]:
    """Triangles in the lower left corner of the world, moves to the opposite corner.

    Nearly every number has as many digits as it can have, so the file has as many bytes as
    its vertices permit, and a buffer made for less is too small.
    """
    for _ in range(scenarios):
        while True:
            robot = in_box(rng, 9, 3)
            move = 2 * LIMIT - rng.between(40, 90), 2 * LIMIT - rng.between(40, 90)
            support = random_support(rng, sweep(robot, move), "start")
            placed = pair(rng, support, in_box(rng, 9, 3), flat=0)
            little = placed.touching if rng.chance(0.5) else placed.missing
            scenario = Scenario(robot, move, [little])
            if fits(scenario):
                break
        left, bottom, _, _ = bounds(scenario)
        yield moved(scenario, (-LIMIT - left, -LIMIT - bottom))
