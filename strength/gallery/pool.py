"""The pool of tiny scenarios that the gallery is chosen from, made from seeds."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice, pairwise
from typing import Any

from gen.build import render_family
from gen.geometry import Point, Polygon
from gen.scenario import Scenario, parse, render
from stress.chance import random_scenarios

MOST_OBSTACLES, MOST_VERTICES = 2, 10
RANDOM_SEED, RANDOM_SCENARIOS = 1, 24_000
REPEATS = (1, 2)
TURNED_REPEAT, TURNS = 2, 8  # its scenarios in turn in the eight symmetries of the plane
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
        found, following = islice(random_scenarios(made["seed"], number + 2), number, None)
        if "joined" in made:
            return _joined(found, following)
        return _scaled(found, made.get("scale", 1))
    scenario = parse(render_family(made["family"], made["parameters"], made["repeat"]))[number]
    return turned(scenario, made.get("turn", 0))


def _all() -> Iterator[Candidate]:
    for family, parameters in (*SMALL, *((name, {}) for name in PRECISE)):
        full: dict[str, int | str] = {"vertices": VERTICES, **parameters}
        for repeat in REPEATS:
            for number, scenario in enumerate(parse(render_family(family, full, repeat)), 1):
                made = {"family": family, "parameters": full, "repeat": repeat, "scenario": number}
                turn = number % TURNS if repeat == TURNED_REPEAT else 0
                if turn:
                    made["turn"] = turn
                yield Candidate(turned(scenario, turn), made)
    randomly = random_scenarios(RANDOM_SEED, RANDOM_SCENARIOS + 1)
    for number, (scenario, following) in enumerate(pairwise(randomly), 1):
        made = {"seed": RANDOM_SEED, "scenario": number}
        yield Candidate(scenario, made)
        if number <= SCALED_SCENARIOS:
            yield Candidate(_scaled(scenario, SCALE), {**made, "scale": SCALE})
        if scenario.obstacles and following.obstacles:
            yield Candidate(_joined(scenario, following), {**made, "joined": number + 1})


def turned(scenario: Scenario, turn: int) -> Scenario:
    """Return a scenario in one of the eight symmetries of the plane; turn 0 changes nothing.

    turn: bit 0 mirrors x, bit 1 mirrors y, then bit 2 swaps the two. Each polygon begins with
    the same vertex.
    """

    def point(p: Point) -> Point:
        x, y = -p[0] if turn & 1 else p[0], -p[1] if turn & 2 else p[1]
        return (y, x) if turn & 4 else (x, y)

    def polygon(vertices: Polygon) -> Polygon:
        first, *others = map(point, vertices)
        return [first, *(reversed(others) if turn.bit_count() % 2 else others)]

    return Scenario(
        polygon(scenario.robot), point(scenario.move), list(map(polygon, scenario.obstacles))
    )


def disguised(scenario: Scenario, turn: int) -> Scenario:
    """Return the same question: turned, with other first vertices and orders of obstacles.

    A program asked in this disguise is a mutant of itself: its mistake comes mirrored.
    """

    def begun(polygon: Polygon) -> Polygon:
        at = turn % len(polygon)
        return polygon[at:] + polygon[:at]

    scenario = turned(scenario, turn)
    obstacles = [begun(obstacle) for obstacle in scenario.obstacles]
    return Scenario(begun(scenario.robot), scenario.move, obstacles[:: -1 if turn % 2 else 1])


def _joined(scenario: Scenario, following: Scenario) -> Scenario:
    """Return a scenario with one obstacle of another as its second."""
    return Scenario(scenario.robot, scenario.move, [scenario.obstacles[0], following.obstacles[0]])


def _scaled(scenario: Scenario, by: int) -> Scenario:
    robot, *obstacles = (
        [(by * x, by * y) for x, y in polygon] for polygon in (scenario.robot, *scenario.obstacles)
    )
    dx, dy = scenario.move
    return Scenario(robot, (by * dx, by * dy), obstacles)
