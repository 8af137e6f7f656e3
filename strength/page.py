"""The kill matrix as one HTML page that needs nothing else: no script, no font, no image."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from html import escape

from judge.kit.text import counted
from judge.problem.verdict import Verdict
from strength.analysis import Analysis
from strength.show import HAND_MADE, LETTERS, cell_text, family_text
from strength.table import Matrix

STYLE = """
:root { color-scheme: light dark; --page: #fff; --ink: #222; --faint: #888; --line: #ddd;
  --kill: #2a7f3f; --kill-ink: #fff; --slow: #8a5a00; --crash: #6b3fa0; --fault: #c62828; }
@media (prefers-color-scheme: dark) { :root { --page: #16181c; --ink: #e4e4e4; --faint: #888;
  --line: #33373d; --kill: #3c9a55; --slow: #b98420; --crash: #8d62c4; --fault: #ef5350; } }
body { background: var(--page); color: var(--ink); margin: 2rem;
  font: 14px/1.4 system-ui, sans-serif; }
h1 { font-size: 1.4rem; } h2 { font-size: 1.1rem; margin-top: 2rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; }
th, td { padding: .1rem .5rem; border-bottom: 1px solid var(--line); text-align: left;
  white-space: nowrap; }
th:first-child { position: sticky; left: 0; background: var(--page); font-weight: normal; }
.cases td { padding: 0; width: 1.1rem; text-align: center; border: 1px solid var(--page); }
.cases thead th { height: 13rem; padding: 0; vertical-align: bottom; border: 0; }
.cases thead th span { writing-mode: vertical-rl; transform: rotate(180deg); }
.AC { color: var(--faint); }
.WA, .RTE, .TLE, .MLE, .OLE, .CE, .JE { color: var(--kill-ink); background: var(--kill); }
.TLE { background: var(--slow); } .RTE, .MLE, .OLE, .CE { background: var(--crash); }
.fault { color: var(--kill-ink); background: var(--fault); font-weight: bold; }
.families { white-space: normal; color: var(--faint); }
"""


def page(matrix: Matrix, analysis: Analysis, families: Mapping[str, str]) -> str:
    """Return the page: findings, submissions x groups, submissions x cases, the cases."""
    faults = "".join(f'<li class="fault">{escape(fault)}</li>' for fault in analysis.faults)
    verdict = f"<ul>{faults}</ul>" if faults else "<p>All submissions are judged as declared.</p>"
    return "\n".join(
        [
            '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8">',
            '<meta name="viewport" content="width=device-width">',
            f"<title>Kill matrix</title><style>{STYLE}</style></head><body>",
            f"<h1>Kill matrix: {counted(len(matrix.rows), 'submission')}, "
            f"{counted(len(matrix.cases), 'case')}</h1>",
            verdict,
            "<h2>By group</h2>",
            "<p>How many cases kill a submission, and the verdict of the group. "
            "After a first TLE (+), the group's other cases are not run.</p>",
            _group_table(analysis),
            "<h2>By case</h2>",
            "<p>W wrong answer, R run-time error, T time limit exceeded, M memory limit exceeded, "
            "O output limit exceeded, C compile error; a point: accepted; blank: not run.</p>",
            _case_grid(matrix),
            "<h2>What each case is good for</h2>",
            _case_list(matrix, analysis, families),
            "</body></html>\n",
        ]
    )


def _table(kind: str, heading: Iterable[str], rows: Iterable[str]) -> str:
    head = "".join(f"<th><span>{escape(text)}</span></th>" for text in heading)
    return (
        f'<div class="scroll"><table class="{kind}"><thead><tr>{head}</tr></thead>\n'
        f"<tbody>{''.join(rows)}</tbody></table></div>"
    )


def _group_table(analysis: Analysis) -> str:
    groups = list(next(iter(analysis.cells.values()), {}))
    rows = []
    for submission, by_group in analysis.cells.items():
        cells = "".join(
            f'<td class="{cell.verdict if cell.as_declared else "fault"}">{cell_text(cell)}</td>'
            for cell in by_group.values()
        )
        names = escape(family_text(dict(analysis.families[submission])))
        rows.append(
            f'<tr><th>{escape(submission)}</th>{cells}<td class="families">{names}</td></tr>\n'
        )
    return _table("groups", ["submission", *groups, "killed by families"], rows)


def _case_grid(matrix: Matrix) -> str:
    rows = []
    for row in matrix.rows:
        cells = "".join(_case_cell(row.verdicts.get(case.name)) for case in matrix.cases)
        rows.append(f"<tr><th>{escape(row.submission)}</th>{cells}</tr>\n")
    names = [case.name.removeprefix("secret/") for case in matrix.cases]
    return _table("cases", ["", *names], rows)


def _case_cell(verdict: Verdict | None) -> str:
    if verdict is None:
        return "<td></td>"
    return f'<td class="{verdict}" title="{verdict}">{LETTERS[verdict]}</td>'


def _case_list(matrix: Matrix, analysis: Analysis, families: Mapping[str, str]) -> str:
    rows = []
    for case in matrix.cases:
        kills = sum(
            row.verdicts.get(case.name, Verdict.AC) is not Verdict.AC for row in matrix.rows
        )
        only = ", ".join(analysis.only_killer.get(case.name, ()))
        in_group = ", ".join(analysis.only_in_group.get(case.name, ()))
        family = families.get(case.name) or HAND_MADE
        rows.append(
            f"<tr><th>{escape(case.name)}</th><td>{escape(family)}</td><td>{kills}</td>"
            f'<td class="families">{escape(only)}</td><td class="families">{escape(in_group)}</td>'
            "</tr>\n"
        )
    heading = ["case", "family", "kills", "only killer of", "only killer within its group of"]
    return _table("list", heading, rows)
