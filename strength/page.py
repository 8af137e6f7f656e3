"""The kill matrix as one HTML page that needs nothing else: no script, no font, no image."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from judge.kit.text import counted
from judge.problem.verdict import Verdict
from judge.reports.page import render
from strength.analysis import Analysis
from strength.show import HAND_MADE, LETTERS, cell_text, family_text
from strength.table import Matrix

TEMPLATES = Path(__file__).with_name("templates")


def page(matrix: Matrix, analysis: Analysis, families: Mapping[str, str]) -> str:
    """Return the page: findings, submissions x groups, submissions x cases, the cases."""
    kills = {
        case.name: sum(
            row.verdicts.get(case.name, Verdict.AC) is not Verdict.AC for row in matrix.rows
        )
        for case in matrix.cases
    }
    return render(
        "matrix.html",
        TEMPLATES,
        matrix=matrix,
        analysis=analysis,
        families=families,
        groups=list(next(iter(analysis.cells.values()), {})),
        names=[case.name.removeprefix("secret/") for case in matrix.cases],
        kills=kills,
        letters=LETTERS,
        hand_made=HAND_MADE,
        counted=counted,
        cell_text=cell_text,
        family_text=family_text,
    )
