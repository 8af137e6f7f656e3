"""Every submission is declared, says its idea first, and is one file without libraries."""

import ast
import re
import sys

import pytest

from judge.kit.paths import ROOT
from judge.problem.declaration import load
from judge.problem.verdict import Verdict

SUBMISSIONS = ROOT / "submissions"
PROBLEM = load()
FILES = sorted(
    path.relative_to(SUBMISSIONS).as_posix()
    for path in SUBMISSIONS.rglob("*")
    if path.is_file() and "__pycache__" not in path.parts
)
PYTHON_FILES = [name for name in FILES if name.endswith(".py")]
VERDICTS_OF_DIRECTORY = {
    "accepted": set(),
    "wrong_answer": {Verdict.WA},
    "time_limit_exceeded": {Verdict.TLE},
    "run_time_error": {Verdict.RTE},
    "compile_error": {Verdict.CE},
}


def expected(name):
    """Return the permitted verdicts of a submission, one set per group."""
    return {group: PROBLEM.expected(name, group) for group in PROBLEM.group_names}


def first_line(name):
    """Return the first line of the opening docstring or comment, without its marks."""
    lines = (SUBMISSIONS / name).read_text(encoding="utf-8").splitlines()
    if lines[0].startswith("#!"):
        lines = lines[1:]
    opening = re.match(r'(?:"""|//) ?(.*?)(?:""")?$', lines[0])
    assert opening, f"{name}: expected a docstring or a // comment first, found {lines[0]!r}"
    return opening[1]


def test_every_file_is_declared_and_every_declared_file_exists():
    assert sorted(PROBLEM.submissions) == FILES


@pytest.mark.parametrize("name", FILES)
def test_first_line_says_the_idea_or_the_bug(name):
    line = first_line(name)
    assert re.match(r"[A-Z0-9].*[.:]$", line), f"expected a sentence, found {line!r}"
    assert len(line.split()) >= 4, f"expected a sentence, found {line!r}"


@pytest.mark.parametrize("name", PYTHON_FILES)
def test_python_runs_on_other_judges(name):
    """PyPy on Kattis may be as old as Python 3.9: no later syntax, and no later library."""
    text = (SUBMISSIONS / name).read_text(encoding="utf-8")
    if not name.startswith("compile_error/"):
        ast.parse(text, feature_version=(3, 9))
    assert not re.search(r"\b(pairwise|batched|bit_count|strict=)\b", text)


def test_no_two_submissions_have_the_same_first_line():
    wrong = [name for name in FILES if not name.startswith("accepted/")]
    assert len({first_line(name) for name in wrong}) == len(wrong)


@pytest.mark.parametrize("name", PYTHON_FILES)
def test_python_submissions_use_the_standard_library_only(name):
    tree = ast.parse((SUBMISSIONS / name).read_text(encoding="utf-8"))
    imported = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            imported |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            imported.add(str(node.module).partition(".")[0])
    assert imported <= sys.stdlib_module_names


@pytest.mark.parametrize("name", FILES)
def test_source_is_within_the_declared_size(name):
    assert (SUBMISSIONS / name).stat().st_size <= PROBLEM.limits.code_kib << 10


@pytest.mark.parametrize("name", FILES)
def test_directory_and_declaration_agree(name):
    directory = name.partition("/")[0]
    verdicts = expected(name)
    if directory == "accepted":
        # Only the last group may fail, and only by time: the textbook method is welcome here.
        last = PROBLEM.group_names[-1]
        assert {group for group, permitted in verdicts.items() if permitted != {Verdict.AC}} <= {
            last
        }
        assert verdicts[last] in ({Verdict.AC}, {Verdict.TLE})
    else:
        own = VERDICTS_OF_DIRECTORY[directory]
        assert any(own <= permitted for permitted in verdicts.values())


def test_there_are_enough_submissions_of_each_kind():
    def count(directory, suffix=""):
        return sum(n.startswith(directory + "/") and n.endswith(suffix) for n in FILES)

    fast = [
        name
        for name in FILES
        if name.startswith("accepted/")
        and all(permitted == {Verdict.AC} for permitted in expected(name).values())
    ]
    assert any(name.endswith(".cpp") for name in fast)
    assert {"accepted/textbook.py", "accepted/textbook.cpp", "accepted/Textbook.java"} <= set(FILES)
    assert count("wrong_answer", ".py") >= 10
    assert count("wrong_answer", ".cpp") >= 10
    assert count("time_limit_exceeded") >= 3
    assert count("run_time_error") >= 2
