"""In what two scenes can be alike: the conditions that they meet, and how they lie."""

from __future__ import annotations

from gen.scenario import Scenario
from strength.gallery.conditions import conditions_of

# Conditions that few scenes meet: a scene of another lesson should meet none of them.
SPECIAL = frozenset(
    {
        *("between-obstacles", "edge-along-move", "edges-cross", "every-moment", "exact"),
        *("obstacle-inside", "on-the-way", "products", "robot-inside", "same-shape"),
        *("standing-still", "start-value", "touch", "touch-at-end", "touch-at-start"),
        *("touch-corners", "vertical-move"),
    }
)
NUMBERS = frozenset({"products", "exact", "start-value"})  # conditions that large numbers meet
LARGE = NUMBERS | {"every-moment"}  # lessons that need large numbers, or long moves


def features_of(scenario: Scenario) -> frozenset[str]:
    """Return the conditions that a scenario meets, its direction, and how it begins."""
    dx, dy = scenario.move
    x, y = scenario.robot[0]
    holds = {
        "leads right": dx > 0,
        "leads left": dx < 0,
        "leads up": dy > 0,
        "is steep": abs(dy) > abs(dx),
        "begins left": x == min(vertex[0] for vertex in scenario.robot),
        "begins low": y == min(vertex[1] for vertex in scenario.robot),
        "has two obstacles": len(scenario.obstacles) > 1,
    }
    return conditions_of(scenario) | {name for name, does in holds.items() if does}
