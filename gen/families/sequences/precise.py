"""Scenes of the precision families in random order.

Attacks inexact arithmetic with many independent chances in one file.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from gen.families.precision.across import across
from gen.families.precision.beyond import beyond
from gen.families.precision.blocks import blocks
from gen.families.precision.chords import chords
from gen.families.precision.diagonal import diagonal
from gen.families.precision.flats import flats
from gen.families.precision.passing import passing
from gen.families.precision.slivers import slivers
from gen.families.precision.tips import tips
from gen.families.registry import Move, Scenarios, Vertices, family
from gen.rng import Rng
from gen.scenario import Scenario


@family
def precise(
    rng: Rng,
    *,
    scenarios: Scenarios = 100_000,
    vertices: Vertices = 2_000,
    move: Move = "any",
) -> Iterator[Scenario]:
    """Scenes of the families that only exact arithmetic gets right, in random order."""
    makers: list[Callable[..., Iterable[Scenario]]] = [
        *(across, beyond, blocks, diagonal, flats, slivers, tips),
        *[chords] * 4,  # some roundings are wrong in one of its scenes in a hundred
    ]
    for _ in range(scenarios):
        if move == "any" and rng.chance(0.1):
            (scenario,) = passing(rng, scenarios=1)
        else:
            (scenario,) = rng.choice(makers)(rng, scenarios=1, move=move)
        vertices -= scenario.vertices
        if vertices < 0:
            return
        yield scenario
