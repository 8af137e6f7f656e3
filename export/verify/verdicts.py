"""`python -m export verdicts`: does every submission get the same verdict everywhere?

The real tools judge every submission on their packages: problemtools with points, group by group,
and BAPCtools pass-fail. The table of their verdicts beside those of checker.py is the evidence.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import takewhile
from pathlib import Path

from export.formats.layout import coarse
from export.package import Package, Submission
from export.targets import TARGETS
from export.verify.job import find_tool, run_tool
from export.verify.kattis import take_any_java
from judge.kit.files import write_whole
from judge.kit.paths import ROOT
from judge.kit.store import Store
from judge.machine import scale_of
from judge.problem.data import load_data
from judge.problem.verdict import Verdict
from judge.sandbox.sandbox import Sandbox
from strength.analysis import analyse
from strength.table import build

TABLE = ROOT / "docs" / "verdicts.md"
SAME, DIFFERENT = 0, 1
# `   brute.py   AC(0):0.05s  AC(15):0.10s  AC(15):0.11s  TLE  TLE   30   0.11s`
KATTIS_CELL = re.compile(r"(AC|WA|TLE|RTE|JE)(?:\(\d+\))?(?::[\d.]+s)?|-")
# `wrong_answer/always_no.py:  WA 0.036s @ sample/01-first`
BAPCTOOLS_LINE = re.compile(r"^(\w+/[\w.-]+): +(AC|WA|TLE|RTE) ", re.MULTILINE)
NOT_RUN = "-"

Verdicts = Mapping[str, str]  # by group


@dataclass(frozen=True, slots=True)
class Row:
    """One submission: its verdicts by group here and in problemtools, and its points there.

    here: for the kit's own two solvers, as expected. kattis: empty if it was not judged there.
    bapctools: one verdict; "" if it was not judged there.
    """

    submission: Submission
    here: Verdicts
    kattis: Verdicts
    points: int
    kattis_points: str
    bapctools: str

    @property
    def differences(self) -> list[str]:
        """Return what differs, in words; nothing if all agree."""
        found = [
            f"{group}: {self.here[group]} here, {verdict} in problemtools"
            for group, verdict in self.kattis.items()
            if verdict not in (NOT_RUN, _coarse_word(self.here[group]))
        ]
        if self.kattis and self.kattis_points != str(self.points):
            found.append(f"{self.points} points here, {self.kattis_points} in problemtools")
        fallen = {_coarse_word(word) for word in self.here.values()} - {Verdict.AC.value}
        if self.bapctools and self.bapctools not in (fallen or {Verdict.AC.value}):
            found.append(f"{self.bapctools} in BAPCtools")
        return found


def _coarse_word(word: str) -> str:
    return next(iter(coarse(frozenset({Verdict(word)})))).value


@dataclass(frozen=True, slots=True)
class Printed:
    """What the tools printed: verifyproblem, and bt run; several runs may follow each other."""

    kattis: str
    bapctools: str


def run_tools(package: Package, scratch: Path) -> Printed:
    """Let the tools judge every submission. Takes the better part of an hour. Raises KitError."""
    kattis = _unpacked(package, "kattis", scratch)
    bapctools = _unpacked(package, "bapctools", scratch)
    take_any_java(kattis.parent)
    verifyproblem = (find_tool("verifyproblem"), "-p", "submissions", "--", kattis.name)
    bt = (find_tool("bt"), "run", "-B")
    return Printed(
        run_tool(verifyproblem, kattis.parent, must_succeed=False),
        run_tool(bt, bapctools, must_succeed=False),
    )


def compare(package: Package, printed: Printed, jobs: int) -> int:
    """Judge every submission here, too; write docs/verdicts.md; return 0 if all verdicts agree.

    Raises KitError.
    """
    here = dict(_judged(package, jobs))
    there = read_kattis(printed.kattis, package)
    single = dict(BAPCTOOLS_LINE.findall(printed.bapctools))
    rows = [
        _row(package, submission, here[submission.name], there, single)
        for submission in package.submissions
        if submission.overall != {Verdict.CE}
    ]
    write_whole(TABLE, as_markdown(package, rows).encode())
    different = [row for row in rows if row.differences]
    for row in different:
        print(f"{row.submission.name}: {'; '.join(row.differences)}")
    print(f"{TABLE}: {len(rows)} submissions, {len(rows) - len(different)} with equal verdicts")
    return DIFFERENT if different else SAME


def _unpacked(package: Package, target: str, scratch: Path) -> Path:
    directory = scratch / target
    TARGETS[target].build(package).write_directory(directory)
    return directory / package.problem.short_name


def _judged(package: Package, jobs: int) -> Iterator[tuple[str, Verdicts]]:
    """Yield the verdicts of this judge by group, for each submission.

    Verdicts are kept, so that only what changed is judged again.
    """
    problem = package.problem
    with Store() as store, Sandbox() as sandbox:
        data = load_data(problem, store=store)
        matrix = build(
            list(problem.submissions),
            data,
            problem,
            sandbox,
            store,
            scale=scale_of(problem, sandbox),
            jobs=jobs,
        )
    for name, cells in analyse(matrix, problem, {}).cells.items():
        yield name, {group: cell.verdict.value for group, cell in cells.items()}
    for submission in package.submissions:
        if submission.name not in problem.submissions:
            yield (
                submission.name,
                {group: min(words).value for group, words in submission.expected.items()},
            )


def read_kattis(text: str, package: Package) -> dict[str, tuple[list[str], str]]:
    """Return verdicts by group and points from verifyproblem's tables, by the file's name."""
    rows = {}
    groups = len(package.groups)
    for table in text.split("Submission results:")[1:]:
        for line in takewhile(lambda line: line.startswith("   "), table.splitlines()[2:]):
            file, *cells = line.split()
            found = [KATTIS_CELL.fullmatch(cell) for cell in cells[:groups]]
            verdicts = [match[1] or NOT_RUN for match in found if match]
            rows[file] = (verdicts, cells[groups])
    return rows


def _row(
    package: Package,
    submission: Submission,
    here: Verdicts,
    kattis: Mapping[str, tuple[list[str], str]],
    bapctools: Mapping[str, str],
) -> Row:
    verdicts, points = kattis.get(submission.file, ([], ""))
    names = [group.name for group in package.groups]
    scored = sum(group.declared.points for group in package.secret if here[group.name] == "AC")
    found = [word for name, word in bapctools.items() if name.endswith(f"/{submission.file}")]
    return Row(
        submission,
        here,
        dict(zip(names, verdicts, strict=bool(verdicts))),
        scored,
        points,
        found[0] if found else "",
    )


def as_markdown(package: Package, rows: Sequence[Row]) -> str:
    """Return the table with its explanation."""
    names = [group.name for group in package.groups]
    head = ["submission", *names, "points", "problemtools", "points", "BAPCtools", "differs"]
    lines = [
        "# The same verdict everywhere",
        "",
        "Every submission, judged by checker.py, by `verifyproblem` of problemtools on the package",
        "`kattis`, and by `bt run` of BAPCtools on the package `bapctools`. Written by",
        "`python -m export verdicts`. A dash: not judged there, because the format has no word for",
        "its verdict. problemtools stops at the first case of a group that fails; MLE and OLE are",
        "RTE there. Where several verdicts are permitted, the order of the cases decides.",
        "",
        _line(head),
        _line(["---"] * len(head)),
    ]
    for row in rows:
        there = " ".join(row.kattis[name] for name in names) if row.kattis else NOT_RUN
        cells = [
            f"`{row.submission.name}`",
            *(row.here[name] for name in names),
            str(row.points),
            there,
            row.kattis_points.partition(".")[0] or NOT_RUN,
            row.bapctools or NOT_RUN,
            "; ".join(row.differences),
        ]
        lines.append(_line(cells))
    return "\n".join(lines) + "\n"


def _line(cells: Sequence[str]) -> str:
    return f"| {' | '.join(cells)} |"
