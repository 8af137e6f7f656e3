"""Finds the test cases in a directory: pairs of an input and an answer file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path

from judge.kit.errors import KitError
from judge.kit.paths import DATA
from judge.kit.text import did_you_mean, printable_name
from judge.problem.declaration import Problem

REBUILD = "run 'make data'"
MAKE_ANSWERS = "--make-answers lets the reference write"


class CasesError(KitError):
    """The test cases cannot be used."""


@dataclass(frozen=True, slots=True)
class Case:
    """One test case. name: its path in the data directory without suffix, `secret/large/03`."""

    name: str
    group: str
    input: Path
    answer: Path


def group_of(name: str) -> str:
    """Return the group of the case called `name`.

    >>> group_of("sample/01"), group_of("secret/large/03"), group_of("loose")
    ('sample', 'large', '.')
    """
    parent, _, _ = name.rpartition("/")
    return parent.removeprefix("secret/") or "."


def case_at(directory: Path, name: str) -> Case:
    """Return the case called `name` in a data directory; its files need not exist."""
    stem = directory / name
    files = (stem.with_name(f"{stem.name}{ending}") for ending in (".in", ".ans"))
    return Case(name, group_of(name), *files)


def find_cases(directory: Path, problem: Problem) -> list[Case]:
    """Return every case below `directory`, sorted by group as declared, then by name.

    A case in `sample/` or `secret/<group>/` belongs to that group. Any other case belongs
    to a group named after its directory (`.` for the top), after the declared ones.
    `invalid_input/` is skipped. Raises CasesError for half a pair, an empty answer
    file, or no case at all. O(n log n) for n files.
    """
    cases = []
    for input_path in input_files(directory):
        name = _name(input_path, directory)
        answer = input_path.with_suffix(".ans")
        if not answer.is_file():
            if directory == DATA:
                raise CasesError(f"{answer}: the answer file is missing; {REBUILD}")
            raise CasesError(f"{answer}: the answer file, which {MAKE_ANSWERS}, is missing")
        if _is_blank(answer):
            raise CasesError(f"{answer}: expected answers, found an empty file")
        cases.append(Case(name, group_of(name), input_path, answer))
    for answer in sorted(directory.absolute().rglob("*.ans")):
        if not answer.with_suffix(".in").is_file():
            raise CasesError(f"{answer.with_suffix('.in')}: the input file of this case is missing")
    if not cases:
        raise CasesError(f"{directory}: expected pairs of .in and .ans files, found none")
    order = problem.group_names
    return sorted(
        cases,
        key=lambda c: (order.index(c.group) if c.group in order else len(order), c.group, c.name),
    )


def input_files(directory: Path) -> list[Path]:
    """Return the input file of every case below `directory`, sorted. Raises CasesError."""
    if not directory.is_dir():
        what = "not a directory" if directory.exists() else "no such directory"
        raise CasesError(f"{directory}: {what}")
    directory = directory.absolute()
    return [
        path
        for path in sorted(directory.rglob("*.in"))
        if not _name(path, directory).startswith("invalid_input/")
    ]


def _name(input_path: Path, directory: Path) -> str:
    """Return the name of a case."""
    name = input_path.relative_to(directory.absolute()).with_suffix("")
    return printable_name(name.as_posix())


def _is_blank(answer: Path) -> bool:
    """Tell whether an answer file is blank: a program that prints nothing would match it."""
    try:
        with answer.open("rb") as file:
            return not any(line.strip() for line in file)
    except OSError as error:
        raise CasesError(f"{answer}: cannot be read: {error.strerror}") from None


def select(cases: Sequence[Case], groups: Sequence[str], globs: Sequence[str]) -> list[Case]:
    """Return the cases of any of `groups` whose name matches any of `globs`; empty means all.

    A glob matches the whole name or its last parts (`03-*`, `large/*`). Raises
    CasesError for a group without cases and for a glob that matches nothing.
    """
    known = sorted({case.group for case in cases})
    for group in groups:
        if group not in known:
            near = did_you_mean(group, known)
            raise CasesError(f"no group {group!r}{near}; expected one of {', '.join(known)}")
    chosen = [case for case in cases if not groups or case.group in groups]
    for glob in globs:
        if not any(_matches(case.name, glob) for case in chosen):
            raise CasesError(f"no test case matches {glob!r} (they look like {chosen[0].name!r})")
    return [c for c in chosen if not globs or any(_matches(c.name, glob) for glob in globs)]


def _matches(name: str, glob: str) -> bool:
    return fnmatchcase(name, glob) or fnmatchcase(name, f"*/{glob}")
