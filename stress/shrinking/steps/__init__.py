"""The steps of shrinking: each module makes one kind of smaller scenarios from one.

A step yields scenarios that may be invalid or larger: `smaller` keeps those that are neither.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from gen.rng import Rng
from gen.scenario import Scenario
from stress.shrinking.measure import Measure, is_valid, measure, numbers_of
from stress.shrinking.steps.chance import changed_at_random
from stress.shrinking.steps.gaps import narrower_gaps
from stress.shrinking.steps.moves import simpler_moves
from stress.shrinking.steps.nudges import nudged
from stress.shrinking.steps.obstacles import fewer_obstacles
from stress.shrinking.steps.places import other_places
from stress.shrinking.steps.scales import scaled_down
from stress.shrinking.steps.shears import sheared
from stress.shrinking.steps.symmetries import images
from stress.shrinking.steps.triangles import replaced_by_triangles
from stress.shrinking.steps.vertices import fewer_vertices

Step = Callable[[Scenario, Rng], Iterator[Scenario]]

# What removes most comes first.
COARSE: tuple[Step, ...] = (
    fewer_obstacles,
    fewer_vertices,
    replaced_by_triangles,
    other_places,
    scaled_down,
    simpler_moves,
)
FINE: tuple[Step, ...] = (narrower_gaps, sheared, images, nudged, changed_at_random)
MOST_FOR_FINE = 100  # vertices: in a larger scenario, nobody looks at single numbers
MOST_CANDIDATES = 2_000  # in a batch
MOST_VERTICES = 60_000  # in a batch
MOST_TRIED = 500_000  # vertices of all candidates, if that permits at least
LEAST_TRIED = 40  # candidates


def smaller(scenario: Scenario, rng: Rng) -> Iterator[list[Scenario]]:
    """Yield batches of different valid scenarios with a smaller measure, each smallest first.

    A batch has at most MOST_CANDIDATES, and MOST_VERTICES in all (but for the last of them). All
    candidates of a small scenario are one or two batches. Of a large one, not all are tried.
    """
    batch: dict[tuple[Measure, tuple[int, ...]], Scenario] = {}
    seen: set[tuple[Measure, tuple[int, ...]]] = set()
    size, vertices, tried = measure(scenario), 0, 0
    most = max(MOST_TRIED, LEAST_TRIED * scenario.vertices)
    for step in COARSE + FINE if scenario.vertices <= MOST_FOR_FINE else COARSE:
        for candidate in step(scenario, rng):
            tried += candidate.vertices
            if tried > most:
                break
            key = measure(candidate), numbers_of(candidate)
            if key[0] < size and key not in seen and is_valid(candidate):
                seen.add(key)
                batch[key] = candidate
                vertices += candidate.vertices
            if len(batch) == MOST_CANDIDATES or vertices > MOST_VERTICES:
                yield [batch[key] for key in sorted(batch)]
                batch, vertices = {}, 0
    if batch:
        yield [batch[key] for key in sorted(batch)]
