"""What checker.py does with a directory or a zip: it judges a whole class."""

from __future__ import annotations

import argparse
from pathlib import Path

from judge.batch.session import Places, judge_class
from judge.judging import Options
from judge.kit.console import PlainConsole
from judge.kit.errors import KitError
from judge.languages.table import by_name
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict

ALL_JUDGED, NOT_ALL = 0, 2
ALONE = ("explain", "junit", "verbose")  # options for one submission


class ClassUsageError(KitError):
    """The options do not fit a whole class."""


def command(asked: argparse.Namespace, problem: Problem, options: Options) -> int:
    """Judge a class as the arguments say and return the exit status."""
    path = Path(asked.submission)
    if asked.csv is None and asked.html is None and asked.json is None:
        kind = "a directory" if path.is_dir() else "a zip"
        raise ClassUsageError(
            f"{path}: expected a source file, found {kind}; for a whole class, say where the "
            "reports go: --csv FILE, --html FILE or --json FILE"
        )
    for option in ALONE:
        if getattr(asked, option, None):
            raise ClassUsageError(f"--{option}: expected one source file, found a class: {path}")
    language = None if asked.language is None else by_name(asked.language)
    places = Places(asked.csv, asked.html, asked.json)
    rows = judge_class(path, problem, options, places, language, PlainConsole())
    failed = any(row.outcome is not None and row.outcome.verdict is Verdict.JE for row in rows)
    return NOT_ALL if failed else ALL_JUDGED
