"""The pool of tiny scenarios that the gallery is chosen from, made from seeds."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from typing import Any

from gen.build import render_family
from gen.scenario import Scenario, parse, render
from stress.chance import random_scenarios

MOST_OBSTACLES, MOST_VERTICES = 2, 10
RANDOM_SEED, RANDOM_SCENARIOS = 1, 40_000
REPEATS = (1, 2)
SCALE, SCALED_SCENARIOS = 30_011, 4_000  # coordinates beyond 16 bits, products beyond 32
VERTICES = 9_000  # of the file that a family makes: some 1,500 scenarios

# Families, with parameters that make scenarios small enough, and the files of precision.
SMALL: tuple[tuple[str, dict[str, int | str]], ...] = (
    ("containment", {"reach": 6, "size": 3, "most": 4}),
    ("cuts", {"reach": 8, "far": 8, "most": 4}),
    ("decoys", {"reach": 6, "far": 8, "size": 4, "most": 4}),
    ("contacts", {"reach": 5, "far": 6, "size": 3, "most": 4, "obstacles": 1}),
    ("contacts", {"reach": 5, "far": 6, "size": 3, "most": 4, "obstacles": 2}),
    ("contacts", {"reach": 5, "far": 6, "size": 3, "most": 4, "obstacles": 1, "move": "zero"}),
    ("parallel", {"bundle": 4, "reach": 2, "stretch": 2, "most": 4, "obstacles": 1}),
    ("random_scenes", {"reach": 6, "far": 6, "size": 4, "most": 4, "obstacles": 2}),
    ("tiny", {"size": 2, "far": 3, "most": 3}),
    ("tiny", {"size": 4, "far": 6, "most": 5}),
    ("tiny", {"far": 0}),
    ("twins", {"reach": 5, "far": 5, "most": 4}),
    ("world", {"order": "random"}),
)
PRECISE = (
    *("across", "beyond", "blocks", "chords", "diagonal"),
    *("flats", "passing", "slivers", "tips", "wedges"),
)


@dataclass(frozen=True, slots=True)
class Candidate:
    """A scenario that may become a scene. made: how it was made, for the scene's `made`."""

    scenario: Scenario
    made: dict[str, Any]

    @property
    def size(self) -> tuple[int, int, int]:
        """Number of obstacles, of vertices, and the largest |coordinate|."""
        scenario = self.scenario
        points = [scenario.move, *scenario.robot, *(v for o in scenario.obstacles for v in o)]
        return len(scenario.obstacles), scenario.vertices, max(max(map(abs, p)) for p in points)


def candidates() -> list[Candidate]:
    """Return the pool, without repetition. Equal on every machine."""
    seen: dict[bytes, Candidate] = {}
    for candidate in _all():
        scenario = candidate.scenario
        if len(scenario.obstacles) <= MOST_OBSTACLES and scenario.vertices <= MOST_VERTICES:
            seen.setdefault(render([scenario]), candidate)
    return list(seen.values())


def remade(made: dict[str, Any]) -> Scenario:
    """Return the scenario that a scene's `made` describes."""
    number: int = made["scenario"] - 1
    if "seed" in made:
        found = next(islice(random_scenarios(made["seed"], RANDOM_SCENARIOS), number, None))
        return _scaled(found, made.get("scale", 1))
    return parse(render_family(made["family"], made["parameters"], made["repeat"]))[number]


def _all() -> Iterator[Candidate]:
    for family, parameters in (*SMALL, *((name, {}) for name in PRECISE)):
        full: dict[str, int | str] = {"vertices": VERTICES, **parameters}
        for repeat in REPEATS:
            for number, scenario in enumerate(parse(render_family(family, full, repeat)), 1):
                made = {"family": family, "parameters": full, "repeat": repeat, "scenario": number}
                yield Candidate(scenario, made)
    for number, scenario in enumerate(random_scenarios(RANDOM_SEED, RANDOM_SCENARIOS), 1):
        made = {"seed": RANDOM_SEED, "scenario": number}
        yield Candidate(scenario, made)
        if number <= SCALED_SCENARIOS:
            yield Candidate(_scaled(scenario, SCALE), {**made, "scale": SCALE})


def _scaled(scenario: Scenario, by: int) -> Scenario:
    robot, *obstacles = (
        [(by * x, by * y) for x, y in polygon] for polygon in (scenario.robot, *scenario.obstacles)
    )
    dx, dy = scenario.move
    return Scenario(robot, (by * dx, by * dy), obstacles)
