"""The comparer: several programs answer the same files, until two of them differ."""

from __future__ import annotations

import hashlib
from collections import deque
from collections.abc import Callable, Generator, Iterable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import closing
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import NamedTuple

from gen.scenario import Scenario, parse, render
from judge.kit.errors import KitError
from judge.kit.files import write_whole
from judge.kit.paths import BUILD
from judge.kit.trusted import read_answers, run_trusted

DISAGREEMENTS = BUILD / "disagreements"
FILES_PER_JOB = 2  # one that is answered, and one made ahead


class NothingComparedError(KitError):
    """There was no scenario to compare programs on."""


class File(NamedTuple):
    """An input file, and how many scenarios it holds."""

    content: bytes
    scenarios: int


@dataclass(frozen=True, slots=True)
class Program:
    """A program ready to run. every: it answers each file whose number is a multiple of this."""

    name: str
    command: tuple[str, ...]
    every: int = 1


@dataclass(frozen=True, slots=True)
class Disagreement:
    """A scenario that programs answer differently. answers: (program's name, answer) of each."""

    scenario: Scenario
    answers: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True)
class Outcome:
    """What was compared, up to the disagreement if there is one.

    yes: how many of the scenarios the first program answered YES. answered: how many each
    of the programs answered, in their order.
    """

    scenarios: int
    yes: int
    answered: tuple[int, ...]
    disagreement: Disagreement | None


def compare(
    files: Iterable[File],
    programs: Sequence[Program],
    *,
    jobs: int,
    progress: Callable[[int], None] = lambda _scenarios: None,
) -> Outcome:
    """Let programs answer files, `jobs` files at a time; stop at the first difference.

    The first program answers every file. progress: called with each number of scenarios
    that are done. Raises ProgramError when a program fails or writes something that is no
    answer, NothingComparedError without any scenario.
    """
    scenarios = yes = 0
    answered = [0] * len(programs)
    with closing(_answered(files, programs, jobs)) as results:
        for file, answers in results:
            place = _first_difference(list(answers.values()))
            compared = file.scenarios if place is None else place + 1
            scenarios += compared
            yes += answers[0][:compared].count("YES")
            for program in answers:
                answered[program] += compared
            if place is not None:
                each = tuple((programs[i].name, given[place]) for i, given in answers.items())
                found = Disagreement(parse(file.content)[place], each)
                return Outcome(scenarios, yes, tuple(answered), found)
            progress(compared)
    if not scenarios:
        raise NothingComparedError("expected scenarios to compare programs on, found none")
    return Outcome(scenarios, yes, tuple(answered), None)


def keep(disagreement: Disagreement) -> Path:
    """Write the scenario as an input file below build/disagreements; return its path.

    Its checksum is part of the name, so that it replaces no other scenario.
    """
    content = render([disagreement.scenario])
    path = DISAGREEMENTS / f"stress-{hashlib.sha256(content).hexdigest()[:12]}.in"
    write_whole(path, content, parents=True)
    return path


def _answered(
    files: Iterable[File], programs: Sequence[Program], jobs: int
) -> Generator[tuple[File, dict[int, list[str]]], None, None]:
    """Yield each file with the answers of the programs whose turn it is, by their index."""
    numbered = enumerate(files)
    running: deque[Future[tuple[File, dict[int, list[str]]]]] = deque()
    with ThreadPoolExecutor(jobs) as pool:
        try:
            while True:
                for number, file in islice(numbered, FILES_PER_JOB * jobs - len(running)):
                    running.append(pool.submit(_answer, number, file, programs))
                if not running:
                    return
                yield running.popleft().result()
        finally:
            pool.shutdown(cancel_futures=True)


def _answer(
    number: int, file: File, programs: Sequence[Program]
) -> tuple[File, dict[int, list[str]]]:
    """Return the file with its answers; equal outputs are read once and share their list."""
    answers = {}
    read: dict[bytes, list[str]] = {}
    for index, program in enumerate(programs):
        if number % program.every == 0:
            output = run_trusted(program.name, program.command, file.content)
            if output not in read:
                read[output] = read_answers(program.name, output, file.scenarios)
            answers[index] = read[output]
    return file, answers


def _first_difference(columns: Sequence[list[str]]) -> int | None:
    """Return the index of the first scenario that is not answered alike; None if all are."""
    if all(column is columns[0] or column == columns[0] for column in columns):
        return None
    rows = enumerate(zip(*columns, strict=True))
    return next(index for index, answers in rows if len(set(answers)) > 1)
