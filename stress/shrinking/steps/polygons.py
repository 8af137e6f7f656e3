"""The polygons of a scenario as one list: the robot first."""

from __future__ import annotations

from collections.abc import Iterator

from gen.geometry import Point, Polygon
from gen.scenario import Scenario


def polygons(scenario: Scenario) -> list[Polygon]:
    """Return the robot, then the obstacles."""
    return [scenario.robot, *scenario.obstacles]


def of_polygons(found: list[Polygon], move: Point) -> Scenario:
    """Return the scenario of these polygons, the robot first."""
    return Scenario(found[0], move, found[1:])


def with_polygon(scenario: Scenario, index: int, polygon: Polygon) -> Scenario:
    """Return the scenario with polygon `index` replaced; 0 is the robot."""
    found = polygons(scenario)
    found[index] = polygon
    return of_polygons(found, scenario.move)


def numbered(scenario: Scenario) -> Iterator[tuple[int, Polygon]]:
    """Yield the polygons with their indices."""
    return enumerate(polygons(scenario))
