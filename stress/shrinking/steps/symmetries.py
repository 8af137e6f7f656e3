"""The images of the scene: symmetries of the grid, the way back, other first vertices."""

from __future__ import annotations

from collections.abc import Iterator

from gen.geometry import Polygon, translated
from gen.rng import Rng
from gen.scenario import SYMMETRIES, Scenario, bounds, moved
from stress.shrinking.steps.polygons import numbered, of_polygons, polygons, with_polygon

MOST_VERTICES = 24


def images(scenario: Scenario, _rng: Rng) -> Iterator[Scenario]:
    """Yield the images, in place and pushed to the axes; each also with tidy first vertices."""
    for image in _images(scenario):
        for placed in (image, _pushed(image)):
            yield placed
            yield of_polygons(list(map(_tidy, polygons(placed))), placed.move)
    for index, polygon in numbered(scenario):
        for first in range(1, min(len(polygon), MOST_VERTICES)):
            yield with_polygon(scenario, index, polygon[first:] + polygon[:first])
        yield with_polygon(scenario, index, _tidy(polygon))


def _images(scenario: Scenario) -> Iterator[Scenario]:
    (dx, dy), back = scenario.move, translated(scenario.robot, scenario.move)
    for one in (scenario, Scenario(back, (-dx, -dy), scenario.obstacles)):
        for turned in SYMMETRIES.values():
            (move,) = turned([one.move], 0, 0)
            yield of_polygons([turned(polygon, 0, 0) for polygon in polygons(one)], move)


def _pushed(scenario: Scenario) -> Scenario:
    left, bottom, _, _ = bounds(scenario)
    return moved(scenario, (-left, -bottom))


def _tidy(polygon: Polygon) -> Polygon:
    """Return the polygon beginning with its lowest, then leftmost vertex."""
    first = min(range(len(polygon)), key=lambda i: (polygon[i][1], polygon[i][0]))
    return polygon[first:] + polygon[:first]
