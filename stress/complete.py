"""Complete small worlds, for the C++ programs: `world.cpp` makes them part by part.

Every part is answered by all of the programs, whose outputs must be the same bytes;
some parts, evenly spread, by the Python programs as well.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path

from gen.parse import parse
from judge.kit.paths import ROOT
from judge.languages.submission import CompileError, compile_submission, read_submission
from judge.problem.declaration import Problem
from judge.sandbox.sandbox import Sandbox
from stress.agree import SOLVERS, Disagreement, SolverError

MAKER = ROOT / "stress" / "world.cpp"
CPP_SOLVERS = (
    ROOT / "submissions" / "accepted" / "textbook.cpp",
    ROOT / "submissions" / "accepted" / "chord_across_edge.cpp",
    ROOT / "submissions" / "time_limit_exceeded" / "brute_force.cpp",
)
PART = 31_250  # scenarios: of at most 16 vertices each, so no file has more than 5 * 10^5
TIME_LIMIT_S = 120.0


@dataclass(frozen=True, slots=True)
class World:
    """One robot and one obstacle on small grids; `world.cpp` says what exactly is in it."""

    robot_side: int
    obstacle_side: int
    reach: int

    def __str__(self) -> str:
        robot, obstacle = (f"{n} x {n}" for n in (self.robot_side, self.obstacle_side))
        return f"robot on {robot}, obstacle on {obstacle}, |dx|, |dy| <= {self.reach}"

    @property
    def arguments(self) -> tuple[str, str, str]:
        """As `world.cpp` takes them."""
        return str(self.robot_side), str(self.obstacle_side), str(self.reach)


# By number of scenarios; the first one serves the tests.
WORLDS = (
    World(2, 2, 4),
    World(3, 3, 4),
    World(4, 3, 2),
    World(3, 4, 2),
    World(4, 4, 1),
)


@dataclass(frozen=True, slots=True)
class Outcome:
    """What was compared. by_python: how many of the scenarios Python answered too."""

    scenarios: int
    yes: int
    by_python: int
    disagreement: Disagreement | None


@dataclass(frozen=True, slots=True)
class Programs:
    """Programs made ready to run: a command for each, by name."""

    maker: tuple[str, ...]
    solvers: dict[str, tuple[str, ...]]
    python_solvers: dict[str, tuple[str, ...]] = field(default_factory=dict)


def compiled(
    problem: Problem,
    sandbox: Sandbox,
    solvers: Iterable[Path] = CPP_SOLVERS,
    python_solvers: Iterable[Path] = SOLVERS,
) -> Programs:
    """Compile the maker and the solvers; they live as long as the sandbox.

    Raises SolverError if one does not compile, LanguageError without a compiler.
    """

    def command(path: Path) -> tuple[str, ...]:
        try:
            return compile_submission(read_submission(path), problem.limits, sandbox).command.argv
        except CompileError as error:
            raise SolverError(f"{path.name}: does not compile: {error}") from None

    return Programs(
        command(MAKER),
        {path.name: command(path) for path in solvers},
        {path.name: (sys.executable, str(path)) for path in python_solvers},
    )


def size(world: World, programs: Programs) -> int:
    """Return the number of scenarios of a world. Raises SolverError."""
    return int(_run([*programs.maker, *world.arguments], b""))


def compare_world(
    world: World,
    programs: Programs,
    *,
    jobs: int,
    part: int = PART,
    python_every: int = 0,
    only_every: int = 1,
    progress: Callable[[int], None] = lambda _scenarios: None,
) -> Outcome:
    """Let all programs answer every scenario; stop at the first difference.

    part: scenarios per file. python_every: the Python programs answer each part whose
    number is a multiple of it, none for 0. only_every: as many parts are left out, to
    compare only a sample. Raises SolverError.
    """
    total = size(world, programs)
    count = yes = by_python = 0
    numbered = islice(enumerate(range(0, total, part)), 0, None, only_every)

    def answered(number: int, start: int) -> tuple[bytes, dict[str, bytes]]:
        arguments = [*world.arguments, str(start), str(min(part, total - start))]
        content = _run([*programs.maker, *arguments], b"")
        solvers = dict(programs.solvers)
        if python_every and number % python_every == 0:
            solvers |= programs.python_solvers
        return content, {name: _run(argv, content) for name, argv in solvers.items()}

    with ThreadPoolExecutor(jobs) as pool:
        try:
            while batch := list(islice(numbered, 2 * jobs)):
                for content, outputs in pool.map(answered, *zip(*batch, strict=True)):
                    first, *others = outputs.values()
                    if any(other != first for other in others):
                        found = _difference(content, outputs)
                        return Outcome(count, yes, by_python, found)
                    scenarios = first.count(b"\n")
                    count += scenarios
                    yes += first.count(b"YES")
                    by_python += scenarios * (len(outputs) > len(programs.solvers))
                    progress(scenarios)
        finally:
            pool.shutdown(cancel_futures=True)
    return Outcome(count, yes, by_python, None)


def _difference(content: bytes, outputs: dict[str, bytes]) -> Disagreement:
    """Return the first scenario that is answered differently. Raises SolverError if none is."""
    scenarios = parse(content)
    answers = {name: output.split() for name, output in outputs.items()}
    for name, found in answers.items():
        if len(found) != len(scenarios):
            raise SolverError(f"{name}: expected {len(scenarios)} answers, found {len(found)}")
    for number, scenario in enumerate(scenarios):
        each = {name: found[number].decode(errors="replace") for name, found in answers.items()}
        if len(set(each.values())) > 1:
            return Disagreement(scenario, each)
    raise SolverError(f"{', '.join(answers)}: the answers agree, but not how they are written")


def _run(argv: Sequence[str], content: bytes) -> bytes:
    name = Path(argv[-1] if argv[0] == sys.executable else argv[0]).name
    try:
        done = subprocess.run(argv, input=content, capture_output=True, timeout=TIME_LIMIT_S)
    except subprocess.TimeoutExpired:
        raise SolverError(f"{name}: no answer within {TIME_LIMIT_S:.0f} s") from None
    if done.returncode:
        raise SolverError(f"{name}: exit status {done.returncode}")
    return done.stdout
