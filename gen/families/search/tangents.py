"""Long edges that are tangent to a large sweep at one vertex.

Attacks programs that choose the sweep's edges to look at by coordinates, by boxes or by the
obstacle's vertices: only a search by angle finds the vertex that decides.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

from gen.families.common import Deciding, Robot, any_vector, big_robot, fitting, turns
from gen.families.registry import (
    Between,
    Far,
    Length,
    Scenarios,
    Vertices,
    family,
)
from gen.geometry import Polygon, step_right, sweep, translated
from gen.geometry.contact import Support, vertex_support
from gen.rng import Rng
from gen.scenario import Disguise, Scenario, disguised, into_corner

TRIES = 20


@family
def tangents(
    rng: Rng,
    *,
    scenarios: Scenarios = 2,
    m: Vertices = 100,
    obstacles: Annotated[int, Between(1, 166_665)] = 50,
    far: Far = 1_000,
    length: Length = 1_000,
    robot: Robot = "circle",
    deciding: Deciding = "pairs",
) -> Iterator[Scenario]:
    """Triangles have an edge of about `length` that is tangent to the sweep at one vertex.

    They stand all around the sweep and miss it by one unit, but for the deciding one (see
    `hugging`). The ends of such an edge are far off, and its bounding box holds many edges of
    the sweep, so only a search by angle finds the vertex that matters.
    """
    for who in turns(rng, deciding, scenarios):

        def make(who: str = who) -> Disguise:
            return _with_tangents(rng, big_robot(rng, robot, m), obstacles, far, length, who)

        too_large = "family tangents: no scene fits the world; make it smaller"
        yield into_corner(rng, fitting(make, TRIES, too_large))


def _with_tangents(
    rng: Rng, robot: Polygon, count: int, far: int, length: int, who: str
) -> Disguise:
    move = any_vector(rng, far) if far else (0, 0)
    covered = sweep(robot, move)
    n = len(covered.vertices)
    first = rng.below(n)
    deciding = {"none": -1, "last": count - 1}.get(who, rng.below(count))
    places = [(first + i * n // count) % n for i in range(count)]
    rng.shuffle(places)
    found = []
    for number, index in enumerate(places):
        support = vertex_support(rng, covered, index)
        triangle = _tangent_triangle(rng, support, length)
        gap = (0, 0) if number == deciding else step_right(support.along)
        found.append(translated(triangle, gap))
    return disguised(rng, Scenario(robot, move, found), reorder=False)


def _tangent_triangle(rng: Rng, support: Support, length: int) -> Polygon:
    """Return a triangle on the right of the line whose longest edge has the base in its middle."""
    (x, y), (right_x, right_y) = support.along, step_right(support.along)
    steps = max(2, length * rng.between(50, 100) // 100 // max(abs(x), abs(y)))
    before = steps * rng.between(30, 70) // 100
    high, lean = rng.between(1, 50), steps // 2
    apex = high * right_x + lean * x, high * right_y + lean * y
    # Counter-clockwise, the obstacle has its interior on the left: it runs against `along`.
    around_start = translated([(steps * x, steps * y), (0, 0), apex], (-before * x, -before * y))
    return translated(around_start, support.base)
