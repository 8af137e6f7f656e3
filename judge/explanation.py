"""What a report tells about a program that is not accepted: lessons, a scenario, what is slow."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True, slots=True)
class FailedScene:
    """A gallery scene that a program answers wrongly.

    input: the whole text of an input file that holds only this scene. found: YES, NO, or in words
    that there was no answer. sentence: why the expected answer is right; picture: SVG text; file:
    where both are kept (the picture beside the input). The last three are empty if nobody asked.
    """

    name: str
    input: str
    expected: str
    found: str
    sentence: str = ""
    picture: str = ""
    file: Path | None = None


@dataclass(frozen=True, slots=True)
class MissedLesson:
    """A lesson that a program misses: its id, its sentence, the gallery scenes answered wrongly.

    scene: the smallest of these scenes, None if there is none or it may not be told.
    """

    id: str
    sentence: str
    scenes: tuple[str, ...]
    scene: FailedScene | None = None


@dataclass(frozen=True, slots=True)
class Like:
    """A wrong submission of the kit that answers every gallery scene in the same way.

    submission: its path in submissions/. bug: what it does wrong, as in `takes touching for free`.
    """

    submission: str
    bug: str


@dataclass(frozen=True, slots=True)
class Diagnosis:
    """What a program's run on the gallery says about it.

    lessons: those it misses, most telling first. like: None unless a submission of the kit
    answers exactly alike. remark: one sentence that needs no scene, such as what is left
    when the program answers the whole gallery correctly; empty if there is none. scenes: how many
    the gallery holds; wrong: how many of them the program does not answer correctly.
    """

    lessons: tuple[MissedLesson, ...]
    like: Like | None
    remark: str
    scenes: int
    wrong: int


@dataclass(frozen=True, slots=True)
class Counterexample:
    """A smallest input that a program gets wrong.

    input: the whole text of the input file. expected, found: the answers to its last scenario;
    found says how the program ended, in words, if it crashed or ran out of time. scenarios: 1,
    or more if the answer to the last one depends on those before it (if it depends on later ones,
    the first wrong one takes the place of the last). obstacles, vertices: of the last scenario.
    sentence: why the expected answer is right. picture: SVG text, empty if there is none. file:
    where the input is kept, None if it is kept nowhere. seconds: what the search took. steps:
    remarks on the search, such as the seed that repeats it. in_step: False if the program ended
    well but did not print one word for each scenario. special: clauses that say what is special
    in the last scenario, exact facts, as `the move is vertical (dx = 0)`.
    """

    input: str
    expected: str
    found: str
    scenarios: int
    obstacles: int
    vertices: int
    sentence: str
    picture: str = ""
    file: Path | None = None
    seconds: float = 0.0
    steps: tuple[str, ...] = field(default=())
    in_step: bool = True
    special: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Size:
    """How large a test case is that a program was too slow for.

    case: its name. family: what made it, empty if that is not known. promise: of its group,
    as the statement words it; empty if it has none. scenarios: how many. robot, obstacles,
    obstacle: the largest m, k and n. walks: the sum of k * m over the scenarios, the steps of
    one walk around the robot for each obstacle. pairs: the sum of m * n over all obstacles, the
    steps of a comparison of each edge of the robot with each edge of each obstacle.
    """

    case: str
    family: str
    promise: str
    scenarios: int
    robot: int
    obstacles: int
    obstacle: int
    walks: int
    pairs: int


@dataclass(frozen=True, slots=True)
class Growth:
    """How a program's CPU time grows with one quantity N of its input; all others stay the same.

    ladder: a short name. quantity: completes `N is ...`. sizes, cpu_s: the values of N in the
    fit, and the seconds without the program's start; only the largest N if no time was long
    enough for a fit. over: the first N that took too long to be measured, or None. exponent: b
    of the curve a * N ** b that fits, None without a fit. may: the exponent to aim at.
    too_fast: the exponent is clearly larger than that.
    """

    ladder: str
    quantity: str
    sizes: tuple[int, ...]
    cpu_s: tuple[float, ...]
    over: int | None
    exponent: float | None
    may: float
    too_fast: bool


@dataclass(frozen=True, slots=True)
class Slowness:
    """What is known about a program that was too slow.

    size: of the first test case that it was too slow for, None if that may not be told or the
    file is no input of this problem. growths: as measured, what to tell first at the beginning;
    empty if nothing was measured.
    """

    size: Size | None
    growths: tuple[Growth, ...] = ()
