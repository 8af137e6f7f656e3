"""What is special in a small scenario: exact facts in words, the rarest first."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from gen.geometry import Point, Polygon, cross, minus, sweep
from gen.scenario import Scenario
from pictures.moment import Contact, Kind, decisive
from pictures.overlap import overlap
from pictures.words import part, place

MOST_FACTS = 3
POINTS_OF_EDGE = 2  # an intersection with more points than an edge has an area
MOST_VERTICES = 24  # in a larger scenario, much is special
MEETINGS = {
    Kind.CORNER_CORNER: "corner on corner",
    Kind.CORNER_EDGE: "the robot's corner on an edge",
    Kind.EDGE_CORNER: "the robot's edge on a corner",
    Kind.EDGE_EDGE: "edge on edge",
}


class _Named(NamedTuple):
    """A polygon, and what it is called."""

    name: str
    polygon: Polygon


def special_facts(scenario: Scenario) -> tuple[str, ...]:
    """Return up to MOST_FACTS facts about a scenario, each a clause, at most one of each kind.

    None about a scenario with more than MOST_VERTICES vertices. O(n^2) for n vertices.

    >>> triangle = [(0, 0), (1, 0), (0, 1)]
    >>> special_facts(Scenario(triangle, (0, 1), [[(5, 5), (7, 6), (6, 8)]]))
    ('the move is vertical (dx = 0)', "the robot's edge (0, 1)–(0, 0) is parallel to the move")
    """
    if scenario.vertices > MOST_VERTICES:
        return ()
    if not scenario.obstacles:
        return ("there is no obstacle (k = 0)",)
    swept = sweep(scenario.robot, scenario.move).vertices
    if telling := next(_of_place(scenario, swept), None):
        return (telling,)  # beside it, lines and coordinates that agree are chance
    named = _Named("the robot" if scenario.move == (0, 0) else "the swept area", swept)
    kinds = [_of_move(scenario), _of_contact(scenario, swept), _along_move(scenario)]
    kinds += [
        _of_all(tell, named, scenario.obstacles)
        for tell in (_separating, _parallel, _in_line, _level)
    ]
    firsts = (next(kind, None) for kind in kinds)
    return tuple(fact for fact in firsts if fact is not None)[:MOST_FACTS]


def _of_all(
    tell: Callable[[_Named, _Named], Iterator[str]],
    swept: _Named,
    obstacles: Sequence[Polygon],
) -> Iterator[str]:
    for number, obstacle in enumerate(obstacles, 1):
        yield from tell(swept, _Named(f"obstacle {number}", obstacle))


def _of_move(scenario: Scenario) -> Iterator[str]:
    dx, dy = scenario.move
    if dx == 0 != dy:
        yield "the move is vertical (dx = 0)"
    if dy == 0 != dx:
        yield "the move is horizontal (dy = 0)"


def _of_contact(scenario: Scenario, swept: Polygon) -> Iterator[str]:
    touch = decisive(scenario)
    if not isinstance(touch, Contact):
        return
    name = f"obstacle {touch.obstacle + 1}"
    touched = sum(bool(overlap(swept, obstacle)) for obstacle in scenario.obstacles)
    if touched > 1:
        yield f"the robot touches {touched} obstacles"
    if touch.kind is Kind.ROBOT_INSIDE:
        yield f"the robot begins wholly inside {name}, so no edges cross there"
    elif touch.kind is Kind.OBSTACLE_INSIDE:
        yield f"{name} is wholly inside the robot from the start, so no edges cross there"
    elif len(overlap(swept, scenario.obstacles[touch.obstacle])) <= POINTS_OF_EDGE:
        yield f"the robot only touches {name}, {MEETINGS[touch.kind]}"


def _of_place(scenario: Scenario, swept: Polygon) -> Iterator[str]:
    """Yield how a shape lies that tests of corners or of edges alone miss."""
    dx, dy = scenario.move
    end = [(x + dx, y + dy) for x, y in scenario.robot]
    robot = "the robot" if scenario.move == (0, 0) else "the swept area"
    for number, obstacle in enumerate(scenario.obstacles, 1):
        inside = all(_is_strictly_inside(vertex, swept) for vertex in obstacle)
        if inside and not overlap(scenario.robot, obstacle) and not overlap(end, obstacle):
            yield (
                f"obstacle {number} lies wholly inside the swept area, and the robot touches it "
                "neither at the start nor at the end"
            )
        shared = overlap(swept, obstacle)
        corners = {*swept, *obstacle}
        if len(shared) > POINTS_OF_EDGE and corners.isdisjoint(shared):
            yield f"{robot} and obstacle {number} cross, and no corner of either lies in the other"


def _is_strictly_inside(point: Point, polygon: Polygon) -> bool:
    return all(cross(minus(b, a), minus(point, a)) > 0 for a, b in _edges(polygon))


def _along_move(scenario: Scenario) -> Iterator[str]:
    for a, b in _edges(scenario.robot):
        if scenario.move != (0, 0) and cross(minus(b, a), scenario.move) == 0:
            yield f"the robot's {part((a, b))} is parallel to the move"


def _separating(swept: _Named, obstacle: _Named) -> Iterator[str]:
    """Yield a fact about two shapes that are apart: only edges of one of them separate them."""
    for near, far in ((swept, obstacle), (obstacle, swept)):
        edges = [edge for edge in _edges(near.polygon) if _is_beyond(far.polygon, edge)]
        if edges and not any(_is_beyond(near.polygon, edge) for edge in _edges(far.polygon)):
            its = part(edges[0])
            yield f"no edge of {far.name} separates the two, but the {its} of {near.name} does"


def _is_beyond(polygon: Polygon, edge: tuple[Point, Point]) -> bool:
    """Tell whether all of a polygon is strictly to the right of an edge, outside its polygon."""
    a, b = edge
    return all(cross(minus(b, a), minus(vertex, a)) < 0 for vertex in polygon)


def _parallel(swept: _Named, obstacle: _Named) -> Iterator[str]:
    for edge in _edges(swept.polygon):
        for other in _edges(obstacle.polygon):
            if cross(minus(edge[1], edge[0]), minus(other[1], other[0])) == 0:
                mine, its = part(edge), part(other)
                yield f"the {mine} of {swept.name} is parallel to the {its} of {obstacle.name}"


def _in_line(swept: _Named, obstacle: _Named) -> Iterator[str]:
    for mine, its in ((swept, obstacle), (obstacle, swept)):
        for a, b in _edges(its.polygon):
            for corner in mine.polygon:
                if corner not in (a, b) and cross(minus(b, a), minus(corner, a)) == 0:
                    yield (
                        f"the corner {place(corner)} of {mine.name} lies on the line through the "
                        f"{part((a, b))} of {its.name}"
                    )


def _level(swept: _Named, obstacle: _Named) -> Iterator[str]:
    for axis, letter in enumerate("yx"):
        for a in swept.polygon:
            for b in obstacle.polygon:
                if a != b and a[1 - axis] == b[1 - axis]:
                    mine, its = f"{place(a)} of {swept.name}", f"{place(b)} of {obstacle.name}"
                    yield f"the corners {mine} and {its} have the same {letter}"


def _edges(polygon: Polygon) -> Sequence[tuple[Point, Point]]:
    return list(zip(polygon, polygon[1:] + polygon[:1], strict=True))
