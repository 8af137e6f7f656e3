"""Loads the test cases of a data directory: finds, selects and checks them in one call."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from judge.kit.checksums import Checksums
from judge.kit.paths import DATA
from judge.kit.store import Store
from judge.problem.cases import REBUILD, Case, CasesError, find_cases, group_of, select
from judge.problem.compact import compact_cases
from judge.problem.declaration import Problem
from judge.problem.given import check_given
from judge.problem.manifest import Manifest, file_faults, load_manifest


@dataclass(frozen=True, slots=True)
class Data:
    """The test cases of a directory, in order. all: every one; chosen: the selected ones."""

    directory: Path
    all: tuple[Case, ...]
    chosen: tuple[Case, ...]
    manifest: Manifest

    @property
    def partial(self) -> bool:
        """Whether `chosen` differs from all of the kit's own cases."""
        return self.directory != DATA or len(self.chosen) < len(self.all)


def load_data(
    problem: Problem,
    directory: Path = DATA,
    groups: Sequence[str] = (),
    globs: Sequence[str] = (),
    store: Store | None = None,
    *,
    compact: bool = False,
) -> Data:
    """Find the test cases of `directory`; choose those of `groups` that match `globs`.

    Empty groups or globs: all. The kit's own directory must have every case of these groups. In
    any directory, the chosen cases must match the manifest; in others, inputs and answers that
    the manifest does not name are checked. store: keeps checksums, so that unchanged files are
    not read again. compact: choose only from the small selection, `compact.json`. Raises
    CasesError, CompactError, ManifestError, ProgramError.
    """
    manifest = load_manifest(directory)
    cases = find_cases(directory, problem)
    if directory == DATA:
        wanted = [name for name in problem.group_names if not groups or name in groups]
        check_complete(manifest, cases, wanted, directory)
    chosen = select(compact_cases(directory, cases) if compact else cases, groups, globs)
    check_unchanged(manifest, chosen, directory, Checksums(store))
    if directory != DATA:
        check_given([case for case in chosen if case.name not in manifest.cases])
    return Data(directory, tuple(cases), tuple(chosen), manifest)


def check_complete(
    manifest: Manifest, cases: Sequence[Case], groups: Sequence[str], directory: Path
) -> None:
    """Raise CasesError if a group has no cases, or lacks one of the manifest.

    Large cases are not committed: they must be built first.
    """
    for group in groups:
        if all(case.group != group for case in cases):
            below = "sample" if group == "sample" else f"secret/{group}"
            raise CasesError(f"{directory / below}: no test cases here yet; {REBUILD}")
    present = {case.name for case in cases}
    for name in manifest.cases:
        if name not in present and group_of(name) in groups:
            raise CasesError(f"{name}: this test case is not built yet; {REBUILD}")


def check_unchanged(
    manifest: Manifest, cases: Sequence[Case], directory: Path, checksums: Checksums
) -> None:
    """Raise CasesError for the first file that differs from the manifest."""
    for case in cases:
        entry = manifest.cases.get(case.name)
        if entry is None:
            continue
        for path, fault in file_faults(directory, case.name, entry, checksums):
            raise CasesError(f"{path}: {fault}; {REBUILD}")
    checksums.keep()
