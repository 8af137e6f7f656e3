"""Several solvers on the same scenarios, until two of them differ."""

from __future__ import annotations

import os
import subprocess
import sys
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from itertools import islice
from pathlib import Path

from gen.scenario import Scenario, render
from judge.kit.errors import KitError
from judge.kit.paths import ROOT

BATCH = 20_000  # scenarios in one file: well below every limit for tiny ones
TIME_LIMIT_S = 600
DISAGREEMENTS = ROOT / "build" / "disagreements"

SOLVERS = (
    ROOT / "solution.py",
    ROOT / "brute.py",
    ROOT / "submissions" / "accepted" / "textbook.py",
)


class SolverError(KitError):
    """A solver failed, or answered nonsense; the message says which and how."""


@dataclass(frozen=True)
class Disagreement:
    """A scenario that two solvers answer differently."""

    scenario: Scenario
    answers: dict[str, str]  # solver's name to answer


@dataclass(frozen=True)
class Agreement:
    """What was compared: number of scenarios, how many of them YES, the first difference."""

    scenarios: int
    yes: int
    disagreement: Disagreement | None


def compare(
    scenarios: Iterable[Scenario],
    solvers: Sequence[Path] = SOLVERS,
    jobs: int | None = None,
    batch: int = BATCH,
) -> Agreement:
    """Let Python programs answer all scenarios; stop at the first difference.

    Solvers read a file of scenarios from stdin, and run in parallel, `jobs` batches
    at a time (all cores unless told). Raises SolverError.
    """
    scenarios = iter(scenarios)
    batches: Iterator[list[Scenario]] = iter(lambda: list(islice(scenarios, batch)), [])
    jobs = jobs or os.cpu_count() or 1
    count = yes = 0
    with ThreadPoolExecutor(jobs) as pool:
        running: deque[tuple[list[Scenario], Future[list[list[str]]]]] = deque()
        while True:
            while len(running) <= jobs and (part := next(batches, None)):
                running.append((part, pool.submit(_answers, part, solvers)))
            if not running:
                return Agreement(count, yes, None)
            part, future = running.popleft()
            columns = future.result()
            for scenario, answers in zip(part, zip(*columns, strict=True), strict=True):
                count += 1
                yes += answers[0] == "YES"
                if len(set(answers)) > 1:
                    names = [solver.name for solver in solvers]
                    found = Disagreement(scenario, dict(zip(names, answers, strict=True)))
                    return Agreement(count, yes, found)


def keep(disagreement: Disagreement) -> Path:
    """Write the scenario as an input file below build/disagreements; return its path."""
    content = render([disagreement.scenario])
    DISAGREEMENTS.mkdir(parents=True, exist_ok=True)
    number = sum(1 for _ in DISAGREEMENTS.glob("*.in")) + 1
    path = DISAGREEMENTS / f"stress-{number}.in"
    path.write_bytes(content)
    return path


def _answers(part: Sequence[Scenario], solvers: Sequence[Path]) -> list[list[str]]:
    """Return one list of answers for each solver."""
    content = render(part)
    return [_run(solver, content, len(part)) for solver in solvers]


def _run(solver: Path, content: bytes, count: int) -> list[str]:
    try:
        done = subprocess.run(
            [sys.executable, str(solver)],
            input=content,
            capture_output=True,
            timeout=TIME_LIMIT_S,
        )
    except subprocess.TimeoutExpired:
        raise SolverError(f"{solver.name}: no answer within {TIME_LIMIT_S} s") from None
    if done.returncode:
        last = done.stderr.decode(errors="replace").strip().splitlines()[-1:]
        raise SolverError(f"{solver.name}: exit status {done.returncode} {''.join(last)}")
    answers = done.stdout.decode(errors="replace").split()
    if len(answers) != count:
        raise SolverError(f"{solver.name}: expected {count} answers, found {len(answers)}")
    return answers
