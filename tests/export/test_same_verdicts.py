"""The table of verdicts: what the judges' tools print is read rightly, and differences are told."""

from __future__ import annotations

import pytest

from export.package import Package
from export.verify.verdicts import BAPCTOOLS_LINE, Row, as_markdown, read_kattis

KATTIS = """\
   wrong_answer/always_no.py (Python 3 (w/PyPy3)) OK: WA [CPU: 0.04s @ testcase secret/1-static/01]
Submission results:
   Submission             sample       1-static      2-small  3-large  4-many  Pts  Time
   solution.py            AC(0):0.0s   AC(15):0.10s  AC(15):0.1s  AC(50):2.1s  AC(20):1.0s  100 2.1s
   brute.py               AC(0):0.07s  AC(15):0.10s  AC(15):0.1s  TLE  TLE  30   7.60s
   always_no.py           WA           WA            -        -        -       0    0.04s
collisioncourse tested: 0 errors, 0 warnings
Submission results:
   Submission             sample       1-static      2-small  3-large  4-many  Pts  Time
   later.py               AC(0):0.07s  RTE           WA       TLE      JE      0    2.10s
"""
BAPCTOOLS = """\
PROBLEM collisioncourse
accepted/solution.py:                       AC 2.067s @ secret/3-large/02-tiny
wrong_answer/always_no.py:                  WA 0.036s @ sample/01-first
"""


def test_the_tables_of_verifyproblem(package: Package) -> None:
    rows = read_kattis(KATTIS, package)
    assert rows["solution.py"] == (["AC"] * 5, "100")
    assert rows["brute.py"] == (["AC", "AC", "AC", "TLE", "TLE"], "30")
    assert rows["always_no.py"] == (["WA", "WA", "-", "-", "-"], "0")
    assert rows["later.py"] == (["AC", "RTE", "WA", "TLE", "JE"], "0")
    assert len(rows) == 4


def test_the_lines_of_bt() -> None:
    assert dict(BAPCTOOLS_LINE.findall(BAPCTOOLS)) == {
        "accepted/solution.py": "AC",
        "wrong_answer/always_no.py": "WA",
    }


def row(package: Package, here: str, kattis: str, bapctools: str = "WA", points: str = "30") -> Row:
    names = [group.name for group in package.groups]
    submission = next(each for each in package.submissions if each.folder == "wrong_answer")
    return Row(
        submission,
        dict(zip(names, here.split(), strict=True)),
        dict(zip(names, kattis.split(), strict=True)) if kattis else {},
        30,
        points,
        bapctools,
    )


@pytest.mark.parametrize(
    ("here", "kattis", "bapctools", "points", "told"),
    [
        ("AC AC AC WA WA", "AC AC AC WA WA", "WA", "30", []),
        ("AC AC AC WA WA", "AC AC AC WA -", "WA", "30", []),
        ("AC AC AC MLE WA", "AC AC AC RTE WA", "RTE", "30", []),
        ("AC AC AC WA WA", "", "", "", []),
        ("AC AC AC WA WA", "AC AC AC TLE WA", "WA", "30", ["large: WA here, TLE in problemtools"]),
        ("AC AC AC WA WA", "AC AC AC WA WA", "AC", "30", ["AC in BAPCtools"]),
        ("AC AC AC WA WA", "AC AC AC WA WA", "", "80", ["30 points here, 80 in problemtools"]),
        ("AC AC AC AC AC", "AC AC AC AC AC", "TLE", "30", ["TLE in BAPCtools"]),
    ],
)
def test_what_differs(
    package: Package, here: str, kattis: str, bapctools: str, points: str, told: list[str]
) -> None:
    assert row(package, here, kattis, bapctools, points).differences == told


def test_the_table_says_what_differs(package: Package) -> None:
    rows = [
        row(package, "AC AC AC WA WA", "AC AC AC WA WA"),
        row(package, "AC AC AC WA WA", "AC AC AC AC WA"),
    ]
    same, different = as_markdown(package, rows).splitlines()[-2:]
    assert same.endswith("| 30 | AC AC AC WA WA | 30 | WA |  |")
    assert different.endswith("| large: WA here, AC in problemtools |")
