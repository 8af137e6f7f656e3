"""Draws scenarios to try: first tiny ones, later those of all families."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count, islice

from gen.families import find
from gen.plan import HAND_MADE, load_plan
from gen.rng import Rng
from gen.scenario import Scenario
from stress.chance import random_scenarios

TINY_FILES = (300, 2_001, 4_000)  # scenarios: most wrong programs fail in the first
LARGER_FILES = 10_000
TINY_IN_LARGER = 9_500  # the others are from families, which take ten times as long to make
MOST = {"scenarios": 40, "vertices": 1_000}  # of a family at a time
NOT_DRAWN = (HAND_MADE, "world")  # the world enumerates; its scenes are like the tiny ones
GROUPS = ("static", "small")  # whose recipes make small scenes


def tiny_files(seed: int) -> Iterator[list[Scenario]]:
    """Yield a few files of tiny random scenarios; equal seeds, equal files."""
    source = random_scenarios(seed, sum(TINY_FILES))
    for size in TINY_FILES:
        yield list(islice(source, size))


def larger_files(seed: int) -> Iterator[list[Scenario]]:
    """Yield files of random scenarios without end, tiny ones and those of all families."""
    rng = Rng(seed)
    families = of_families(rng)
    for number in count(1):
        file = list(random_scenarios(seed + number, TINY_IN_LARGER))
        file += islice(families, LARGER_FILES - TINY_IN_LARGER)
        yield file


def of_families(rng: Rng) -> Iterator[Scenario]:
    """Yield scenarios without end, made as the plan's small test cases are, from other seeds."""
    planned = [recipe for recipe in load_plan() if recipe.group in GROUPS]
    recipes = [recipe for recipe in planned if recipe.family not in NOT_DRAWN]
    while True:
        recipe = rng.choice(recipes)
        family = find(recipe.family)
        fewer = {name: most for name, most in MOST.items() if name in family.domains}
        parameters = family.resolve({**recipe.parameters, **fewer})
        made = family.make(Rng(rng.below(1 << 60)), **parameters)
        vertices = 0
        for scenario in islice(made, MOST["scenarios"]):
            yield scenario
            vertices += scenario.vertices
            if vertices > MOST["vertices"]:
                break
