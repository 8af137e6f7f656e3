"""A template repository for students: each push is judged by GitHub Actions.

It holds the kit without what would give the solution away: the reference, the brute force, the
submissions, and the pictures, whose code computes Minkowski sums. So a report names the lessons
that a program misses, and has no smallest counterexample.
"""

from __future__ import annotations

import re
from pathlib import Path

from export.files import Files
from export.kit import KIT, Parts, kit_files, rebuilt
from export.package import STATEMENT, ExportError, Package
from export.target import Target
from judge.kit.paths import PROBLEM_FILE, ROOT

TEMPLATE = Path(__file__).parents[1] / "classroom"
LAYOUT = {
    "README.md": "README.md",
    "judge.yml": ".github/workflows/judge.yml",
    "starter.py": "starters/solution.py",
    "starter.cpp": "starters/solution.cpp",
    "Starter.java": "starters/Solution.java",
}
IGNORED = ("__pycache__/", "/reports/", f"/{KIT}.venv/", f"/{KIT}build/")
FIGURE = re.compile(r"\]\(([\w./-]+\.svg)\)")
TELLS = 'tell = "counterexample"'
FRONT = "stress.front"  # which adds --explain


def build(package: Package) -> Files:
    """Lay out the README, the statement, the workflow, the starters and the kit."""
    files = kit_files(package, _parts())
    for name, place in LAYOUT.items():
        files.add(place, TEMPLATE / name)
    files.add(STATEMENT.name, STATEMENT)
    for figure in FIGURE.findall(STATEMENT.read_text(encoding="utf-8")):
        files.add(figure, ROOT / figure)
    inputs = (f"/{KIT}data/{name}.in" for name in rebuilt(package))
    files.add(".gitignore", "".join(f"{line}\n" for line in (*IGNORED, *inputs)))
    return files


def _parts() -> Parts:
    """Return the parts of the kit that students may have. Raises ExportError."""
    return Parts(
        rooms=("gen", "judge"),
        files=(),
        replaced=(
            _replaced(PROBLEM_FILE, TELLS, 'tell = "lessons"', 'tell = "verdict"'),
            _replaced(ROOT / "checker.py", FRONT, "judge.cli"),
        ),
    )


def _replaced(file: Path, old: str, new: str, *others: str) -> tuple[str, str]:
    """Return the name of a file and its text with `new` for `old`.

    Raises ExportError if it holds neither `old`, `new`, nor one of `others`.
    """
    text = file.read_text(encoding="utf-8")
    if not any(word in text for word in (old, new, *others)):
        raise ExportError(f"{file}: expected {old!r}, found none")
    return file.name, text.replace(old, new)


TARGETS = (
    Target(
        name="classroom",
        title="GitHub, template repository for students",
        build=build,
        import_it=(
            "Push this directory as a repository, mark it as a template at Settings, and let each "
            "student make a private repository from it."
        ),
        directory=True,
        compact=True,
    ),
)
