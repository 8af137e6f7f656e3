"""Loads and checks `problem.toml`, the declaration of the problem."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Annotated, Literal

import msgspec

from judge.kit.errors import KitError
from judge.kit.paths import PROBLEM_FILE
from judge.kit.text import did_you_mean
from judge.problem.verdict import Verdict

Positive = Annotated[int, msgspec.Meta(ge=1)]
PositiveFloat = Annotated[float, msgspec.Meta(gt=0)]
Uuid = Annotated[str, msgspec.Meta(pattern="^[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}$")]
Name = Annotated[str, msgspec.Meta(pattern="^[a-z][a-z0-9_-]*$")]


class SpecError(KitError):
    """`problem.toml` cannot be used; the message says where, expected and found."""


class Strict(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Base of every table: frozen, and an unknown key is an error."""


class TimeMultipliers(Strict, frozen=True):
    """Safety margins of the time limit, as Kattis defines them."""

    ac_to_time_limit: Annotated[float, msgspec.Meta(ge=1)]
    time_limit_to_tle: Annotated[float, msgspec.Meta(ge=1)]


class Limits(Strict, frozen=True):
    """What one run of a submission, and one compilation, may use."""

    time_limit_s: PositiveFloat
    memory_mib: Positive
    output_mib: Positive
    code_kib: Positive
    compilation_time_s: PositiveFloat
    compilation_memory_mib: Positive
    time_multipliers: TimeMultipliers


class Calibration(Strict, frozen=True):
    """The reference's CPU seconds on one case, on the machine that set the limit."""

    case: str
    reference_cpu_s: PositiveFloat


class Constraints(Strict, frozen=True):
    """The bounds that every input file keeps."""

    max_scenarios: Positive
    max_vertices: Positive
    max_coordinate: Positive
    min_polygon_vertices: Positive


class Group(Strict, frozen=True):
    """A test group, which scores all or nothing, and its promises beyond the constraints."""

    name: Name
    points: Annotated[int, msgspec.Meta(ge=0)]
    promise: str
    max_vertices: Positive | None = None
    max_pair_sum: Positive | None = None
    zero_displacement: bool = False


class Feedback(Strict, frozen=True):
    """How much a report tells about a program that is not accepted.

    tell: the verdict only; also the lessons that it misses; also a counterexample.
    name_secret_cases: reports name the secret cases, and the place of a difference in them.
    """

    tell: Literal["verdict", "lessons", "counterexample"]
    name_secret_cases: bool

    @property
    def lessons(self) -> bool:
        """Whether missed lessons are told."""
        return self.tell != "verdict"

    @property
    def counterexample(self) -> bool:
        """Whether a counterexample is told."""
        return self.tell == "counterexample"


class Problem(Strict, frozen=True):
    """The content of `problem.toml`."""

    name: str
    short_name: Name
    license: str
    rights_owner: str
    uuid: Uuid
    limits: Limits
    calibration: Calibration
    constraints: Constraints
    feedback: Feedback
    groups: list[Group]
    folders: dict[str, dict[str, str]]
    submissions: dict[str, dict[str, str]]

    @property
    def max_score(self) -> int:
        """The points of all groups together."""
        return sum(group.points for group in self.groups)

    @property
    def group_names(self) -> list[str]:
        """The groups in their order, `sample` first."""
        return [group.name for group in self.groups]

    def expected(self, submission: str, group: str) -> frozenset[Verdict]:
        """Return the permitted verdicts of a submission (path below submissions/) in a group.

        The submission's own entry counts first, then its folder's, then AC. Raises KeyError for
        an undeclared submission.
        """
        folder = self.folders.get(submission.partition("/")[0], {})
        declared = self.submissions[submission].get(group, folder.get(group, Verdict.AC.value))
        return frozenset(Verdict(word) for word in declared.split("|"))


def load(path: Path = PROBLEM_FILE) -> Problem:
    """Read and check the declaration. Raises SpecError with one clear line."""
    try:
        table = tomllib.loads(path.read_bytes().decode())
    except OSError as error:
        raise SpecError(f"{path}: cannot be read: {error.strerror}") from None
    except UnicodeDecodeError as error:
        raise SpecError(f"{path}: not UTF-8 text (byte {error.start})") from None
    except tomllib.TOMLDecodeError as error:
        raise SpecError(f"{path}: not valid TOML: {error}") from None
    try:
        problem = msgspec.convert(table, Problem)
    except msgspec.ValidationError as error:
        raise SpecError(f"{path}: {_explain(str(error), table)}") from None
    _check_names(problem, path)
    return problem


def _check_names(problem: Problem, path: Path) -> None:
    names = problem.group_names
    if len(set(names)) != len(names):
        raise SpecError(f"{path}: groups: a name occurs twice in {names}")
    lines = {f"folders.{folder}": expected for folder, expected in problem.folders.items()}
    lines |= {f'submissions."{name}"': expected for name, expected in problem.submissions.items()}
    for line, expected in lines.items():
        where = f"{path}: {line}"
        for group, words in expected.items():
            if group not in names:
                raise SpecError(f"{where}: no group {group!r}{did_you_mean(group, names)}")
            for word in words.split("|"):
                if word not in Verdict.__members__:
                    known = ", ".join(Verdict.__members__)
                    raise SpecError(f"{where}: {group}: expected one of {known}, found {word!r}")


def _explain(message: str, table: object) -> str:
    """Turn msgspec's message into `where: what`, with a suggestion for an unknown key."""
    what, _, where = message.partition(" - at ")
    where = where.strip("`").removeprefix("$").removeprefix(".")
    unknown = re.search(r"unknown field `(.*)`", what)
    if unknown:
        key = unknown[1]
        what = f"unknown key {key!r}{did_you_mean(key, _known_keys(where))}"
    missing = re.search(r"missing required field `(.*)`", what)
    if missing:
        what = f"key {missing[1]!r} is missing"
    return f"{where}: {what}" if where else what


def _known_keys(where: str) -> list[str]:
    """Return the keys of the table that `where` names (`limits.time_multipliers`, `groups[0]`)."""
    tables: dict[str, type[Strict]] = {
        "": Problem,
        "limits": Limits,
        "limits.time_multipliers": TimeMultipliers,
        "calibration": Calibration,
        "constraints": Constraints,
        "feedback": Feedback,
        "groups": Group,
    }
    return list(tables[re.sub(r"\[.*?\]", "", where)].__struct_fields__)
