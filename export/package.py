"""What every package is made of: the problem, its test cases, submissions and invalid inputs."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from export.statement.read import Statement, read_statement
from judge.kit.errors import KitError
from judge.kit.paths import BRUTE_FORCE, DATA, REFERENCE, ROOT, SUBMISSIONS
from judge.kit.store import Store
from judge.problem.cases import Case
from judge.problem.data import load_data
from judge.problem.declaration import Group, Problem, load
from judge.problem.manifest import Manifest
from judge.problem.verdict import Verdict

STATEMENT = ROOT / "problem.md"
INVALID = DATA / "invalid_input"
ACCEPTED = frozenset({Verdict.AC})


class ExportError(KitError):
    """A package cannot be made."""


@dataclass(frozen=True, slots=True)
class TestGroup:
    """A test group with its cases. declared: its entry in problem.toml."""

    declared: Group
    cases: tuple[Case, ...]

    @property
    def name(self) -> str:
        """The name of the group, `sample` for the samples."""
        return self.declared.name


@dataclass(frozen=True, slots=True)
class Submission:
    """A program with a known verdict.

    name: `accepted/textbook.cpp`. expected: the permitted verdicts by group.
    """

    name: str
    path: Path
    expected: Mapping[str, frozenset[Verdict]]

    @property
    def overall(self) -> frozenset[Verdict]:
        """The permitted verdicts where all groups count as one, as on a judge without points."""
        failing = [permitted for permitted in self.expected.values() if permitted != ACCEPTED]
        return frozenset().union(*failing) - ACCEPTED if failing else ACCEPTED

    @property
    def folder(self) -> str:
        """The folder of the submission, `wrong_answer`."""
        return self.name.partition("/")[0]

    @property
    def file(self) -> str:
        """The name of the file, `textbook.cpp`."""
        return self.path.name


@dataclass(frozen=True, slots=True)
class InvalidInput:
    """A file that the input validator must reject. group: held to its promises; "": to none.

    line, reason: where and what the kit's validator reports.
    """

    name: str
    path: Path
    group: str
    line: int
    reason: str


@dataclass(frozen=True, slots=True)
class Package:
    """All that the exporters lay out, each in its own way.

    compact: the cases are the small selection, not all.
    """

    problem: Problem
    statement: Statement
    groups: tuple[TestGroup, ...]
    submissions: tuple[Submission, ...]
    invalid_inputs: tuple[InvalidInput, ...]
    manifest: Manifest
    compact: bool = False

    @property
    def samples(self) -> tuple[Case, ...]:
        """The sample cases."""
        return next(group.cases for group in self.groups if group.name == "sample")

    @property
    def secret(self) -> tuple[TestGroup, ...]:
        """The test groups without the samples, in their order."""
        return tuple(group for group in self.groups if group.name != "sample")

    def points(self, submission: Submission) -> int:
        """Return the points of a submission: of the groups in which it is accepted."""
        return sum(
            group.declared.points
            for group in self.groups
            if submission.expected[group.name] == ACCEPTED
        )


def load_package(*, compact: bool = False) -> Package:
    """Read everything that a package is made of. Raises KitError if a part is missing.

    compact: choose the cases of `data/compact.json` only.
    """
    problem = load()
    with Store() as store:
        data = load_data(problem, store=store, compact=compact)
    chosen = data.chosen
    return Package(
        problem=problem,
        statement=read_statement(STATEMENT),
        groups=tuple(
            TestGroup(group, tuple(case for case in chosen if case.group == group.name))
            for group in problem.groups
        ),
        submissions=tuple(_submissions(problem)),
        invalid_inputs=tuple(_invalid_inputs()),
        manifest=data.manifest,
        compact=compact,
    )


def _submissions(problem: Problem) -> Iterator[Submission]:
    """Yield the declared submissions, and the two solvers of the kit itself."""

    def expected(name: str) -> dict[str, frozenset[Verdict]]:
        return {group: problem.expected(name, group) for group in problem.group_names}

    yield Submission(
        f"accepted/{REFERENCE.name}", REFERENCE, dict.fromkeys(problem.group_names, ACCEPTED)
    )
    slow = problem.folders["time_limit_exceeded"]
    yield Submission(
        f"time_limit_exceeded/{BRUTE_FORCE.name}",
        BRUTE_FORCE,
        {
            group: frozenset(map(Verdict, slow.get(group, Verdict.AC.value).split("|")))
            for group in problem.group_names
        },
    )
    for name in problem.submissions:
        yield Submission(name, SUBMISSIONS / name, expected(name))


def _invalid_inputs() -> Iterator[InvalidInput]:
    path = INVALID / "faults.toml"
    for name, fault in tomllib.loads(path.read_text(encoding="utf-8")).items():
        yield InvalidInput(
            name, INVALID / f"{name}.in", fault.get("group", ""), fault["line"], fault["reason"]
        )
