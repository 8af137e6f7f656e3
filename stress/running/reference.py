"""The reference's answers, computed in this process: thousands of scenarios need no other one."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import cache
from importlib.util import module_from_spec, spec_from_file_location
from typing import Any

from gen.geometry import Polygon
from gen.scenario import Scenario
from judge.kit.errors import KitError
from judge.kit.paths import REFERENCE

Coordinates = tuple[list[int], list[int]]


class ReferenceError(KitError):
    """The reference solution cannot be loaded."""


def answers(scenarios: Iterable[Scenario]) -> list[str]:
    """Return the answer to each scenario. Raises ReferenceError."""
    return [answer(scenario) for scenario in scenarios]


def answer(scenario: Scenario) -> str:
    """Return YES or NO: what solution.py prints for a valid scenario. About 10 microseconds."""
    sweep = _sweep()(*_coordinates(scenario.robot), *scenario.move, len(scenario.obstacles))
    touches: Callable[..., bool] = sweep.touches
    met = any(touches(*_coordinates(obstacle)) for obstacle in scenario.obstacles)
    return "NO" if met else "YES"


@cache
def _sweep() -> Callable[..., Any]:
    """Return the class of the reference that knows all that the robot covers."""
    spec = spec_from_file_location("reference", REFERENCE)
    if spec is None or spec.loader is None:
        raise ReferenceError(f"{REFERENCE}: expected a Python program")
    module = module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
        found: Callable[..., Any] = module.Sweep
    except (OSError, SyntaxError, AttributeError) as error:
        raise ReferenceError(f"{REFERENCE}: expected the class Sweep: {error}") from None
    return found


def _coordinates(polygon: Polygon) -> Coordinates:
    return [x for x, _ in polygon], [y for _, y in polygon]
