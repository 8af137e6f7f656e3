"""Which file counts, among all that students hand in."""

from __future__ import annotations

from pathlib import Path

import pytest

from autograder.source import handed_in
from judge.languages.submission import SubmissionError

PYTHON = "import sys\nprint(sys.stdin.read())\n"


def hand_in(directory: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        (directory / name).parent.mkdir(parents=True, exist_ok=True)
        (directory / name).write_text(text)
    return directory


@pytest.mark.parametrize(
    "files",
    [
        {"solution.py": PYTHON},
        {"my first program.py": PYTHON},
        {"week 3/src/a.py": PYTHON, "week 3/README.md": "hello", "week 3/data.in": "1"},
        {"a.py": PYTHON, "__MACOSX/._a.py": "x", "._a.py": "x", ".DS_Store": "x", ".git/b.py": "x"},
        {"program.txt": PYTHON},
        {"program": PYTHON},
    ],
)
def test_one_program_is_found(files: dict[str, str], tmp_path: Path) -> None:
    submission = handed_in(hand_in(tmp_path, files))
    assert submission.language.name == "Python 3"
    assert submission.name == next(iter(files))


@pytest.mark.parametrize(
    ("files", "said"),
    [
        ({}, "expected one source file, found none"),
        ({"__MACOSX/._a.py": "x"}, "expected one source file, found none"),
        ({"a.py": PYTHON, "b/c.cpp": ""}, "one source file, found 2 files: a.py, b/c.cpp"),
        (
            {f"{n}.py": "" for n in range(8)},
            "8 files: 0.py, 1.py, 2.py, 3.py, 4.py and 3 more",
        ),
        ({"a.md": "x", "b.pdf": "x"}, "expected one source file, found 2 files: a.md, b.pdf"),
        ({"README.md": "My answer."}, "README.md: expected a suffix among .rs .cpp"),
        ({"x/a.py": " \n"}, "x/a.py: expected a source text, found nothing in it"),
        ({"a.py": "print(1)\0"}, "a.py: expected a source text, found binary data"),
    ],
)
def test_anything_else_is_refused_with_a_reason(
    files: dict[str, str], said: str, tmp_path: Path
) -> None:
    with pytest.raises(SubmissionError) as caught:
        handed_in(hand_in(tmp_path, files))
    assert said in str(caught.value)
    assert str(tmp_path) not in str(caught.value)


def test_a_link_is_no_program(tmp_path: Path) -> None:
    """It could lead to the reference solution."""
    (tmp_path / "reference.py").write_text(PYTHON)
    (tmp_path / "submission").mkdir()
    (tmp_path / "submission" / "a.py").symlink_to(tmp_path / "reference.py")
    (tmp_path / "submission" / "b").symlink_to(tmp_path)
    with pytest.raises(SubmissionError, match="found none"):
        handed_in(tmp_path / "submission")
