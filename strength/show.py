"""The kill matrix for people who read a terminal, and for programs that read JSON."""

from __future__ import annotations

import msgspec
from rich.console import Console
from rich.table import Table
from rich.text import Text

from judge.kit.text import counted
from judge.problem.verdict import Verdict
from strength.analysis import Analysis, GroupCell
from strength.table import Matrix

LETTERS = {verdict: verdict.value[0] for verdict in Verdict} | {Verdict.AC: "."}
HAND_MADE = "by hand"
FORMAT_VERSION = 1
FAMILIES_WIDTH = 60  # of that column on a terminal


def cell_text(cell: GroupCell) -> str:
    """Return `AC`, or the number of kills and their verdict: `12 WA`; `1+ TLE`: a lower bound."""
    if cell.verdict is Verdict.AC:
        return "AC"
    more = "+" if cell.verdict is Verdict.TLE else ""
    return f"{cell.killed}{more} {cell.verdict}"


def family_text(families: dict[str, int]) -> str:
    """Return the families with their numbers of kills, most kills first: `contacts 4, tiny 2`."""
    return ", ".join(f"{name or HAND_MADE} {count}" for name, count in families.items())


def print_groups(console: Console, analysis: Analysis) -> None:
    """Print submissions x groups, in red what problem.toml does not declare.

    Long lists of families are cut on a terminal, with an ellipsis.
    """
    table = Table(show_edge=False, pad_edge=False)
    table.add_column("submission", no_wrap=True)
    groups = list(next(iter(analysis.cells.values()), {}))
    for group in groups:
        table.add_column(group, justify="right", no_wrap=True)
    width = FAMILIES_WIDTH if console.is_terminal else None
    table.add_column("killed by families", no_wrap=True, overflow="ellipsis", max_width=width)
    for submission, by_group in analysis.cells.items():
        texts = [_coloured(cell) for cell in by_group.values()]
        table.add_row(submission, *texts, family_text(dict(analysis.families[submission])))
    console.print(table)


def _coloured(cell: GroupCell) -> Text:
    if not cell.as_declared:
        return Text(cell_text(cell), style="bold white on red")
    return Text(cell_text(cell), style="dim" if cell.verdict is Verdict.AC else "green")


def print_cases(console: Console, matrix: Matrix) -> None:
    """Print submissions x cases, one letter each, and the cases by column."""
    console.print("\n. AC, W WA, T TLE, R RTE, M MLE, O OLE, C CE, blank: not run", style="dim")
    width = max((len(row.submission) for row in matrix.rows), default=0)
    tens = "".join(str(i // 10 % 10) for i in range(1, len(matrix.cases) + 1))
    ones = "".join(str(i % 10) for i in range(1, len(matrix.cases) + 1))
    for digits in (tens, ones):
        console.print(Text(f"{'':{width}}  {digits}", style="dim"), soft_wrap=True)
    for row in matrix.rows:
        letters = "".join(
            LETTERS[row.verdicts[case.name]] if case.name in row.verdicts else " "
            for case in matrix.cases
        )
        console.print(Text(f"{row.submission:{width}}  {letters}"), soft_wrap=True)
    for number, case in enumerate(matrix.cases, 1):
        console.print(Text(f"{number:3} {case.name}", style="dim"), soft_wrap=True)


def print_findings(console: Console, matrix: Matrix, analysis: Analysis, *, needless: bool) -> None:
    """Print what cases are needed for, how many are not needed, and every fault.

    needless: also name the cases that are not needed.
    """
    for title, found in (
        ("only killer of", analysis.only_killer),
        ("only killer within its group of", analysis.only_in_group),
    ):
        for case, submissions in sorted(found.items()):
            text = f"{case}: {title} {', '.join(submissions)}"
            console.print(Text(text), soft_wrap=True)
    count = f"{len(analysis.needless)} of {len(matrix.cases)}"
    which = f": {', '.join(analysis.needless)}" if needless else " (--cases names them)"
    text = f"cases whose kills are all repeated elsewhere in their group: {count}{which}"
    console.print(Text(text, style="dim"), soft_wrap=True)
    for fault in analysis.faults:
        console.print(Text(fault, style="bold red"), soft_wrap=True)
    if not analysis.faults:
        judged = f"{counted(len(matrix.rows), 'submission')} judged, all as declared"
        console.print(Text(judged, style="green"))


def as_json(matrix: Matrix, analysis: Analysis) -> bytes:
    """Return everything: verdicts by submission and case, and the findings."""
    rows = [
        {
            "submission": row.submission,
            "groups": {
                group: {
                    "verdict": cell.verdict,
                    "killed": cell.killed,
                    "ran": cell.ran,
                    "as_declared": cell.as_declared,
                }
                for group, cell in analysis.cells[row.submission].items()
            },
            "families": {
                name or HAND_MADE: count
                for name, count in analysis.families[row.submission].items()
            },
            "cases": row.verdicts,
        }
        for row in matrix.rows
    ]
    content = {
        "version": FORMAT_VERSION,
        "cases": [case.name for case in matrix.cases],
        "submissions": rows,
        "only_killer": analysis.only_killer,
        "only_killer_in_group": analysis.only_in_group,
        "needless": analysis.needless,
        "faults": analysis.faults,
    }
    return msgspec.json.format(msgspec.json.encode(content), indent=1) + b"\n"
