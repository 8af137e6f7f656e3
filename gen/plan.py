"""The plan: every test case, as data. Adding one moves no other (see `gen.seeds`)."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass, field
from pathlib import Path

from judge.kit.errors import KitError
from judge.kit.paths import DATA

USER_CASES = "cases.toml"  # below data/: cases that users added, kept by every build

Parameters = dict[str, int | str]

HAND_MADE = ""  # stands for the family of a case whose .in is written by hand


class PlanError(KitError):
    """The list of added cases cannot be used; one clear line."""


@dataclass(frozen=True)
class Case:
    """One test case: where it lies, and how it is made.

    repeat: tells apart cases of equal family and parameters; part of the seed.
    """

    group: str
    name: str
    family: str = HAND_MADE
    parameters: Parameters = field(default_factory=dict)
    repeat: int = 1

    @property
    def path(self) -> str:
        """The case's path below data/, without ending."""
        return (
            f"sample/{self.name}" if self.group == "sample" else f"secret/{self.group}/{self.name}"
        )


# Parameters that many cases share: scenes nearly as wide as the world, and corners of it.
HUGE: Parameters = {"reach": 90_000_000, "size": 90_000_000, "corner": 1}
STILL: Parameters = {"move": "zero"}
FULL: Parameters = {"vertices": 500_000}
NARROW: Parameters = {"reach": 1, "size": 3, "most": 3}  # of `in_line`: hardly wider than an edge
WIDE: Parameters = {"reach": 400, "far": 1_000, "most": 20}  # of `cuts`: robots of some size
TANGENT: Parameters = {"m": 600, "obstacles": 100, "length": 2_000}
BIG_TANGENT: Parameters = {
    "m": 250_000,
    "obstacles": 60_000,
    "far": 1_000_000,
    "length": 20_000_000,
}
LARGE_TANGENT: Parameters = {
    "scenarios": 1,
    "m": 1_300,
    "obstacles": 220,
    "length": 10_000,
    "deciding": "any",
}
LOWEST: Parameters = {"m": 510, "pole": "lowest"}
NESTED: Parameters = {"scenarios": 6, "m": 320}
FREE: Parameters = {"deciding": "none"}
PAIRS: Parameters = {"m": 500, "obstacles": 1, "n": 490, "robot": "random"}
LARGE_ROBOT: Parameters = {"scenarios": 1, "m": 1_990, "obstacles": 3, "deciding": "any"}
LARGE_OBSTACLE: Parameters = {"scenarios": 1, "m": 9, "obstacles": 1, "n": 1_990, "deciding": "any"}
HUNDREDS: Parameters = {"scenarios": 1, "m": 200, "obstacles": 600, "deciding": "last"}
LARGEST_ROBOT: Parameters = {"scenarios": 1, "m": 499_997, "obstacles": 1, "deciding": "any"}
ONE_ON_ONE: Parameters = {"scenarios": 1, "m": 1_000, "obstacles": 1, "n": 1_000}

PLANNED = (
    Case("sample", "01-first"),
    Case("sample", "02-sweep"),
    Case("sample", "03-touch"),
    Case("sample", "04-notch"),
    # static: do two convex polygons meet?
    Case("static", "01-world", "world", {"far": 0}),
    Case(
        "static", "02-world", "world", {"far": 0, "grid": 2, "order": "random", "vertices": 2_000}
    ),
    Case("static", "03-tiny", "tiny", {"far": 0}),
    Case("static", "04-contacts", "contacts", STILL),
    Case("static", "05-contacts-huge", "contacts", STILL | HUGE),
    Case("static", "06-scenes", "random_scenes", STILL),
    Case("static", "07-scenes-huge", "random_scenes", STILL | HUGE),
    Case("static", "08-containment", "containment", STILL),
    Case("static", "09-parallel", "parallel", STILL),
    Case("static", "10-decoys", "decoys", STILL),
    Case("static", "11-across", "across", STILL),
    Case("static", "12-rooms", "rooms", STILL),
    Case("static", "13-mixture", "mixture", STILL),
    Case("static", "14-round", "contacts", STILL | {"most": 60, "reach": 4_000, "size": 2_000}),
    Case("static", "15-cuts", "cuts", STILL),
    Case("static", "16-cuts-round", "cuts", STILL | {"reach": 400, "most": 40}),
    Case("static", "17-slivers", "slivers", STILL),
    Case("static", "18-diagonal", "diagonal", STILL),
    Case("static", "19-hugging", "hugging", {"far": 0, "scenarios": 6, "obstacles": 20, "n": 9}),
    Case("static", "20-in-line", "in_line", STILL),
    Case("static", "21-wedges", "wedges"),
    Case("static", "22-rounds", "rounds", STILL),
    Case("static", "23-in-line-narrow", "in_line", STILL | NARROW),
    Case("static", "24-diagonal-again", "diagonal", STILL, repeat=2),
    Case("static", "25-cuts-wide", "cuts", STILL | WIDE),
    # Of thirty, those in which the rarest roundings go wrong.
    Case("static", "26-chords", "chords", STILL, repeat=22),
    Case("static", "27-chords-again", "chords", STILL, repeat=16),
    Case("static", "28-flats", "flats", STILL),
    Case("static", "29-beyond", "beyond", STILL, repeat=4),
    Case("static", "30-tips", "tips", STILL),
    Case("static", "31-blocks", "blocks", STILL),
    Case("static", "32-twins", "twins", {"far": 0}),
    Case("static", "33-tangents", "tangents", TANGENT | {"far": 0}),
    Case("static", "34-poles", "poles", {"far": 0}),
    Case("static", "35-nested", "nested", NESTED | {"far": 0}),
    Case("static", "36-facing", "facing", {"scenarios": 2, "m": 499}),
    Case("static", "37-one-on-one", "hugging", PAIRS | {"far": 0}),
    Case("static", "38-one-on-one-arcs", "hugging", PAIRS | {"far": 0, "robot": "arc"}),
    Case("static", "39-large-robot", "hugging", LARGE_ROBOT | {"far": 0}),
    Case("static", "40-large-obstacle", "hugging", LARGE_OBSTACLE | {"far": 0}),
    Case("static", "41-hundreds", "hugging", HUNDREDS | {"far": 0}),
    Case("static", "42-large-robot-free", "hugging", LARGE_ROBOT | {"far": 0} | FREE),
    Case("static", "43-large-obstacle-free", "hugging", LARGE_OBSTACLE | {"far": 0} | FREE),
    Case("static", "44-tangents-of-a-large-robot", "tangents", LARGE_TANGENT | {"far": 0}),
    Case("static", "45-poles-lowest", "poles", LOWEST | {"far": 0}),
    Case("static", "46-poles-lowest-again", "poles", LOWEST | {"far": 0}, repeat=2),
    Case("static", "47-chords-third", "chords", STILL, repeat=10),
    # small: everything that the brute force can still agree to
    Case("small", "01-world", "world", {"grid": 2, "order": "random", "vertices": 2_000}),
    Case("small", "02-tiny", "tiny"),
    Case("small", "03-tiny-quads", "tiny", {"most": 6, "size": 5, "far": 5}),
    Case("small", "04-contacts", "contacts"),
    Case("small", "05-contacts-start", "contacts", {"place": "start"}),
    Case("small", "06-contacts-side", "contacts", {"place": "side"}),
    Case("small", "07-contacts-end", "contacts", {"place": "end"}),
    Case("small", "08-contacts-huge", "contacts", HUGE | {"far": 90_000_000}),
    Case(
        "small",
        "09-contacts-far",
        "contacts",
        {"reach": 1_000, "size": 1_000, "far": 190_000_000, "corner": 1, "place": "side"},
    ),
    Case("small", "10-scenes", "random_scenes"),
    Case("small", "11-scenes-huge", "random_scenes", HUGE | {"far": 90_000_000}),
    Case("small", "12-scenes-crowded", "random_scenes", {"obstacles": 60, "size": 5}),
    Case("small", "13-containment", "containment"),
    Case("small", "14-containment-huge", "containment", HUGE | {"size": 20_000_000}),
    Case("small", "15-parallel", "parallel"),
    Case("small", "16-parallel-long", "parallel", {"bundle": 20, "reach": 5_000, "stretch": 2_000}),
    Case("small", "17-decoys", "decoys"),
    Case("small", "18-across", "across"),
    Case("small", "19-rooms", "rooms"),
    Case("small", "20-rooms-sheared", "rooms", {"shear": 20_000, "corner": 1}),
    Case("small", "21-mixture", "mixture"),
    Case("small", "22-hugging", "hugging", {"scenarios": 5, "m": 100, "n": 10, "obstacles": 30}),
    Case("small", "23-cuts", "cuts"),
    Case("small", "24-cuts-round", "cuts", {"reach": 400, "far": 1_000, "most": 40}),
    Case("small", "25-cuts-huge", "cuts", {"reach": 9_000_000, "far": 9_000_000, "corner": 1}),
    Case("small", "26-slivers", "slivers"),
    Case("small", "27-diagonal", "diagonal"),
    Case("small", "30-in-line", "in_line"),
    Case("small", "31-rounds", "rounds"),
    Case("small", "32-in-line-narrow", "in_line", NARROW),
    Case("small", "33-cuts-wide", "cuts", WIDE),
    Case("small", "34-chords", "chords"),
    Case("small", "35-chords-again", "chords", repeat=2),
    Case("small", "36-flats", "flats"),
    Case("small", "37-beyond", "beyond"),
    Case("small", "38-passing", "passing"),
    Case("small", "39-tips", "tips"),
    Case("small", "40-blocks", "blocks"),
    Case("small", "41-twins", "twins"),
    Case("small", "42-tangents", "tangents", TANGENT),
    Case("small", "43-poles", "poles"),
    Case("small", "44-nested", "nested", NESTED),
    Case("small", "45-one-on-one-random", "hugging", PAIRS),
    Case("small", "46-one-on-one-arcs", "hugging", PAIRS | {"robot": "arc"}),
    Case("small", "47-large-robot", "hugging", LARGE_ROBOT),
    Case("small", "48-large-obstacle", "hugging", LARGE_OBSTACLE),
    Case("small", "49-hundreds", "hugging", HUNDREDS),
    Case("small", "50-large-robot-again", "hugging", LARGE_ROBOT, repeat=2),
    Case("small", "51-large-obstacle-again", "hugging", LARGE_OBSTACLE, repeat=2),
    Case("small", "52-large-robot-free", "hugging", LARGE_ROBOT | FREE),
    Case("small", "53-large-obstacle-free", "hugging", LARGE_OBSTACLE | FREE),
    Case("small", "54-tangents-of-a-large-robot", "tangents", LARGE_TANGENT),
    Case("small", "55-poles-lowest", "poles", LOWEST),
    Case("small", "56-poles-lowest-again", "poles", LOWEST, repeat=2),
    Case("small", "57-world-in-order", "world", {"vertices": 2_000}),
    # Two polygons as large as a file of this group permits: one answer each.
    Case("small", "28-one-on-one", "hugging", ONE_ON_ONE | {"deciding": "none"}),
    Case("small", "29-one-on-one-touching", "hugging", ONE_ON_ONE | {"deciding": "any"}),
    # large: sizes, but little k * m. First of all a cheap case in which most wrong ideas fail.
    Case("large", "00-mixture", "mixture", {"vertices": 30_000}),
    Case(
        "large",
        "01-largest",
        "hugging",
        {"scenarios": 1, "m": 250_000, "obstacles": 4, "n": 62_500, "deciding": "none"},
    ),
    Case("large", "02-tiny", "tiny", FULL | {"scenarios": 100_000, "empty": 34}),
    Case("large", "03-contacts", "contacts", FULL | HUGE | {"far": 90_000_000}),
    Case("large", "04-mixture", "mixture", {"vertices": 60_000}),
    Case("large", "05-world", "world", FULL),
    Case(
        "large",
        "06-one-on-one",
        "hugging",
        {"scenarios": 8, "m": 30_000, "n": 30_000, "obstacles": 1, "far": 20_000_000},
    ),
    Case(
        "large",
        "07-thousands",
        "hugging",
        {"scenarios": 1, "m": 1_000, "obstacles": 1_000, "n": 400, "deciding": "last"},
    ),
    Case(
        "large",
        "08-longest-robot",
        "hugging",
        {"scenarios": 1, "m": 499_997, "obstacles": 1, "deciding": "none", "robot": "random"},
    ),
    Case(
        "large",
        "09-most-obstacles",
        "hugging",
        {"scenarios": 1, "m": 3, "obstacles": 166_665, "far": 1_000_000, "deciding": "last"},
    ),
    Case(
        "large",
        "10-arcs",
        "hugging",
        {"scenarios": 4, "m": 20_000, "obstacles": 8, "n": 5_000, "robot": "arc"},
    ),
    Case(
        "large",
        "11-one-on-one-random",
        "hugging",
        {"scenarios": 12, "m": 15_000, "n": 20_000, "obstacles": 1, "robot": "random"},
    ),
    # Long moves: the box of every vertex's path overlaps nearly every edge's.
    Case(
        "large",
        "12-far",
        "hugging",
        {"scenarios": 1, "m": 150_000, "n": 60_000, "obstacles": 4, "far": 100_000_000}
        | {"deciding": "none"},
    ),
    Case(
        "large",
        "13-far-pairs",
        "hugging",
        {"scenarios": 4, "m": 60_000, "n": 30_000, "obstacles": 2, "far": 100_000_000},
    ),
    Case("large", "14-cuts", "cuts", {"vertices": 30_000, "reach": 400, "far": 400, "most": 40}),
    Case("large", "15-slivers", "slivers", {"vertices": 10_000}),
    Case("large", "16-diagonal", "diagonal", {"vertices": 10_000}),
    # Small polygons, long moves: a uniform grid over a scene has all vertices in a few cells.
    Case(
        "large",
        "17-far-and-small",
        "hugging",
        {"scenarios": 16, "m": 15_000, "n": 15_000, "obstacles": 1, "far": 190_000_000}
        | {"deciding": "none"},
    ),
    Case("large", "18-in-line", "in_line", {"vertices": 60_000}),
    Case("large", "19-rounds", "rounds", {"vertices": 60_000}),
    Case("large", "20-precise", "precise", {"vertices": 60_000}),
    Case(
        "large",
        "21-tangents",
        "tangents",
        {"scenarios": 12, "m": 20_000, "obstacles": 3, "far": 100_000, "length": 400_000},
    ),
    Case("large", "22-poles", "poles", {"scenarios": 100, "m": 1_500, "far": 60}),
    Case("large", "23-nested", "nested", {"scenarios": 20, "m": 8_000, "size": 1_000}),
    # What the largest polygons hide from arrays too short and searches too few.
    Case("large", "24-largest-robot", "hugging", LARGEST_ROBOT),
    Case("large", "25-largest-robot-still", "hugging", LARGEST_ROBOT | {"far": 0, "m": 280_000}),
    Case(
        "large",
        "26-largest-obstacle",
        "hugging",
        {"scenarios": 1, "m": 3, "obstacles": 1, "n": 499_997, "deciding": "any"},
    ),
    Case(
        "large",
        "27-large-obstacles",
        "hugging",
        {"scenarios": 1, "m": 30, "obstacles": 7, "n": 70_000, "deciding": "any"},
    ),
    Case("large", "28-longest-file", "longest", {"scenarios": 75_000}),
    Case("large", "29-facing", "facing", {"scenarios": 2, "m": 110_000}),
    Case("large", "30-chords", "chords", {"vertices": 60_000}),
    # many: one unit decides, wherever one looks
    Case("many", "00-mixture", "mixture", {"vertices": 30_000}, repeat=2),
    Case(
        "many",
        "01-triangles",
        "hugging",
        {"scenarios": 1, "m": 250_000, "obstacles": 83_333, "flat": 50, "deciding": "last"},
    ),
    Case(
        "many",
        "02-triangles-free",
        "hugging",
        {"scenarios": 1, "m": 200_000, "obstacles": 100_000, "deciding": "none", "robot": "random"},
    ),
    Case(
        "many",
        "03-triangles-far",
        "hugging",
        {"scenarios": 2, "m": 100_000, "obstacles": 50_000, "flat": 3, "far": 90_000_000},
    ),
    Case("many", "04-scenes", "hugging", {"scenarios": 40, "m": 4_000, "obstacles": 1_500}),
    Case(
        "many",
        "05-polygons",
        "hugging",
        {"scenarios": 2, "m": 120_000, "obstacles": 1_800, "n": 72, "far": 10_000_000},
    ),
    Case(
        "many",
        "06-arcs",
        "hugging",
        {"scenarios": 10, "m": 5_000, "obstacles": 8_000, "robot": "arc", "flat": 2},
    ),
    # What one mixture catches by a single scenario, the other has to catch as well.
    Case("many", "07-mixture", "mixture", {"vertices": 60_000}, repeat=3),
    Case("many", "08-precise", "precise", {"vertices": 60_000}, repeat=2),
    # Obstacles whose boxes, and every window of coordinates, are full of the sweep's edges.
    Case(
        "many",
        "09-tangents",
        "tangents",
        BIG_TANGENT | {"scenarios": 1, "deciding": "last"},
    ),
    Case(
        "many",
        "10-tangents-free",
        "tangents",
        BIG_TANGENT | {"scenarios": 2, "m": 100_000, "obstacles": 20_000, "length": 6_000_000},
    ),
    Case(
        "many",
        "11-110000-obstacles",
        "hugging",
        {"scenarios": 1, "m": 1_000, "obstacles": 110_000, "deciding": "last"},
    ),
    Case(
        "many",
        "12-large-polygons",
        "hugging",
        {"scenarios": 8, "m": 10_000, "obstacles": 10, "n": 5_000},
    ),
    Case("many", "13-nested", "nested", {"scenarios": 8, "m": 30_000, "size": 10_000}),
    Case(
        "many",
        "14-largest-polygons",
        "hugging",
        {"scenarios": 1, "m": 50_000, "obstacles": 6, "n": 70_000, "deciding": "any"},
    ),
    Case(
        "many",
        "15-largest-robot",
        "hugging",
        {"scenarios": 1, "m": 280_000, "obstacles": 6_600, "deciding": "any"},
    ),
    Case("many", "16-poles", "poles", {"scenarios": 100, "m": 1_500, "far": 60}, repeat=2),
    Case("many", "17-world", "world", {"vertices": 60_000}),
)


def user_cases(data: Path = DATA) -> tuple[Case, ...]:
    """Return the cases that users added. PlanError if their list cannot be used."""
    path = data / USER_CASES
    try:
        table = tomllib.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return ()
    except (OSError, ValueError) as error:
        raise PlanError(f"{path}: cannot be used: {error}") from None
    try:
        return tuple(Case(**entry) for entry in table["case"])
    except (TypeError, KeyError) as error:
        raise PlanError(f"{path}: expected [[case]] tables of a case's fields: {error}") from None


def all_cases(data: Path = DATA) -> tuple[Case, ...]:
    """Return the planned cases and those that users added, in order of groups."""
    return PLANNED + user_cases(data)


def user_case_entry(case: Case) -> str:
    """Return the lines of `cases.toml` that describe a case."""
    values = ", ".join(
        f"{name} = {_toml(value)}" for name, value in sorted(case.parameters.items())
    )
    return (
        f"\n[[case]]\ngroup = {_toml(case.group)}\nname = {_toml(case.name)}\n"
        f"family = {_toml(case.family)}\nparameters = {{ {values} }}\nrepeat = {case.repeat}\n"
    )


def _toml(value: int | str) -> str:
    """Return an integer or a plain word (no quotes, no control characters) as TOML."""
    return str(value) if isinstance(value, int) else f'"{value}"'
