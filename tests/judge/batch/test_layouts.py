"""Whose hand-in is it: the downloads of Moodle, Canvas, Gradescope, DOMjudge, and others."""

from __future__ import annotations

import os
import random
import stat
import zipfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

import pytest

from judge.batch.entries import MOST_FILES, ClassError, entries_of, is_class
from judge.batch.gradescope import students
from judge.batch.session import read_class
from judge.kit.paths import ROOT
from judge.languages.table import by_name
from judge.problem.declaration import load

PROGRAM = "import sys\nprint('YES')\n"
PROBLEM = load()

METADATA = """\
---
submission_123:
  :submitters:
  - :name: Ann Lee
    :sid: '7'
  - :name: 'Bob O''Hara'
    :email: bob@example.org
  :created_at: 2026-11-20 10:00:00
  :history:
  - :name: not a submitter
submission_124:
  :submitters:
  - :name: "Zo\\u00eb"
"""

LAYOUTS: dict[str, tuple[dict[str, str], dict[str, tuple[str, bool]]]] = {
    "Moodle": (
        {
            "Ann Lee_123_assignsubmission_file_/prog.py": PROGRAM,
            "Ann Lee_123_assignsubmission_onlinetext_/onlinetext.html": "<p>hello</p>",
            "Ann Lee_124_assignsubmission_file_/src/Main.java": "class Main {}",
        },
        {
            "Ann Lee_123_assignsubmission_file_/prog.py": ("Ann Lee", False),
            "Ann Lee_124_assignsubmission_file_/src/Main.java": ("Ann Lee", False),
        },
    ),
    "Moodle, flat": (
        {
            "Ann Lee_123_assignsubmission_file_prog.py": PROGRAM,
            "Bob_9_assignsubmission_file_a_b.py": PROGRAM,
        },
        {
            "Ann Lee_123_assignsubmission_file_prog.py": ("Ann Lee", False),
            "Bob_9_assignsubmission_file_a_b.py": ("Bob", False),
        },
    ),
    "Canvas": (
        {
            "leeann_123_4567_prog.py": PROGRAM,
            "leeann_123_4567_notes.pdf": "x",
            "oharabob_LATE_124_4568_my_prog-1.py": PROGRAM,
        },
        {
            "leeann_123_4567_prog.py": ("leeann", False),
            "oharabob_LATE_124_4568_my_prog-1.py": ("oharabob", True),
        },
    ),
    "Gradescope": (
        {
            "assignment_5_export/submission_metadata.yml": METADATA,
            "assignment_5_export/submission_123/prog.py": PROGRAM,
            "assignment_5_export/submission_124/prog.py": PROGRAM,
            "assignment_5_export/submission_125/prog.py": PROGRAM,
        },
        {
            "assignment_5_export/submission_123/prog.py": ("Ann Lee, Bob O'Hara", False),
            "assignment_5_export/submission_124/prog.py": ("Zoë", False),
            "assignment_5_export/submission_125/prog.py": ("submission_125", False),
        },
    ),
    "DOMjudge": (
        {"s1.py": PROGRAM, "team 7/s2.py": PROGRAM, "team 7/s3/x.py": PROGRAM},
        {
            "s1.py": ("s1", False),
            "team 7/s2.py": ("team 7", False),
            "team 7/s3/x.py": ("team 7", False),
        },
    ),
    "folders of a team or a student": (
        {"hand-ins/ann/a.py": PROGRAM, "hand-ins/ann/README": "x", "hand-ins/bob/b.py": PROGRAM},
        {"hand-ins/ann/a.py": ("ann", False), "hand-ins/bob/b.py": ("bob", False)},
    ),
    "one student": ({"ann/src/a.py": PROGRAM}, {"ann/src/a.py": ("ann", False)}),
    "files": (
        {"ann.py": PROGRAM, "ann.cpp": "int main() {}"},
        {"ann.cpp": ("ann", False), "ann.py": ("ann", False)},
    ),
}


def class_of(place: Path, files: Mapping[str, str], kind: str) -> Path:
    """Write a directory or zip that holds these files."""
    if kind == "zip":
        with zipfile.ZipFile(place / "class.zip", "w") as archive:
            for name, text in files.items():
                archive.writestr(name, text)
        return place / "class.zip"
    for name, text in files.items():
        (place / "class" / name).parent.mkdir(parents=True, exist_ok=True)
        (place / "class" / name).write_text(text)
    return place / "class"


@pytest.mark.parametrize("kind", ["directory", "zip"])
@pytest.mark.parametrize("layout", LAYOUTS)
def test_student_and_file_are_found(layout: str, kind: str, tmp_path: Path) -> None:
    files, expected = LAYOUTS[layout]
    path = class_of(tmp_path, files, kind)
    assert is_class(path)
    rows = read_class(path, PROBLEM, None)
    assert {row.file: (row.student, row.late) for row in rows} == expected
    assert [row.reason for row in rows] == [""] * len(rows)


@pytest.mark.parametrize("kind", ["directory", "zip"])
def test_what_cannot_be_judged_has_a_reason(kind: str, tmp_path: Path) -> None:
    files = {
        "ann/a.py": PROGRAM,
        "ann/b.py": PROGRAM,
        "bob/notes.txt": "just words",
        "carl/a.py": "",
        "dora/a.py": f"x = '{'x' * (PROBLEM.limits.code_kib << 10)}'",
        "eve/a.py": "x\0",
        "finn/.hidden.py": PROGRAM,
        "finn/a.pdf": "x",
        "finn/b.pdf": "x",
        "gus/a.py": PROGRAM,
        "__MACOSX/gus/a.py": "x",
    }
    path = class_of(tmp_path, files, kind)
    reasons = {row.student: row.reason for row in read_class(path, PROBLEM, None)}
    assert list(reasons) == ["ann", "bob", "carl", "dora", "eve", "finn", "gus"]
    for student, words in {
        "ann": "expected one source file, found 2 files: ann/a.py, ann/b.py",
        "bob": "the language cannot be guessed",
        "carl": "found nothing in it",
        "dora": "more than 256 KiB",
        "eve": "found binary data",
        "finn": "found 2 files",
    }.items():
        assert words in reasons[student]
    assert reasons["gus"] == ""
    told = read_class(path, PROBLEM, by_name("C++"))
    assert {row.submission.language.name for row in told if row.submission} == {"C++"}


def test_the_only_students_folder_is_no_wrapper(tmp_path: Path) -> None:
    folder = "Ann Lee_123_assignsubmission_file_"
    path = class_of(tmp_path, {f"{folder}/{name}.py": PROGRAM for name in "ab"}, "zip")
    (row,) = read_class(path, PROBLEM, None)
    assert (row.student, row.file) == ("Ann Lee", folder)
    assert "found 2 files" in row.reason


def test_an_empty_folder_and_a_link_are_rows(tmp_path: Path) -> None:
    path = class_of(tmp_path, {"ann/a.py": PROGRAM}, "directory")
    (path / "bob").mkdir()
    (path / "carl").mkdir()
    (path / "carl" / "a.py").symlink_to(ROOT / "solution.py")
    (path / "dora").symlink_to(ROOT / "submissions")
    reasons = {row.student: row.reason for row in read_class(path, PROBLEM, None)}
    assert reasons == {
        "ann": "",
        "bob": "expected one source file, found none",
        "carl": "expected a regular file, found a link",
        "dora": "expected a regular file, found a link",
    }


def test_a_zip_with_hostile_names(tmp_path: Path) -> None:
    path = tmp_path / "class.zip"
    link = zipfile.ZipInfo("eve/link.py")
    link.external_attr = (stat.S_IFLNK | 0o777) << 16
    with zipfile.ZipFile(path, "w") as archive:
        for name in ("../../up.py", "/etc/absolute.py", "C:\\drive.py", "a\\..\\..\\back.py"):
            archive.writestr(name, PROGRAM)
        archive.writestr(link, "/etc/passwd")
        archive.writestr("\x1b[2J\u202e.py", PROGRAM)
        archive.writestr("twin.py", PROGRAM)
        with pytest.warns(UserWarning, match="Duplicate"):
            archive.writestr("twin.py", PROGRAM + "#")
        for folder in ("zoe/", "./", "."):
            archive.writestr(folder, "")
    before = sorted(tmp_path.rglob("*"))
    rows = {row.file: row for row in read_class(path, PROBLEM, None)}
    assert sorted(tmp_path.rglob("*")) == before
    for name in ("../../up.py", "/etc/absolute.py", "C:/drive.py", "a/../../back.py"):
        assert rows[name].reason == "its name leads out of the archive"
    assert rows["eve/link.py"].reason == "expected a regular file, found a link"
    assert rows["\\x1b[2J\\u202e.py"].reason == ""
    assert "two files with the same name" in rows["twin.py"].reason
    assert rows["zoe"].reason == "expected one source file, found none"
    assert len(rows) == 8


def test_a_damaged_or_encrypted_member_is_a_row(tmp_path: Path) -> None:
    path = class_of(tmp_path, {"ann.py": PROGRAM, "bob.py": "print('NO')\n"}, "zip")
    content = path.read_bytes().replace(b"print('NO')", b"print('ON')")
    path.write_bytes(content)
    reasons = {row.student: row.reason for row in read_class(path, PROBLEM, None)}
    assert reasons["ann"] == ""
    assert "cannot be read: Bad CRC-32" in reasons["bob"]
    encrypted = bytearray(content)
    encrypted[encrypted.index(b"PK\x01\x02") + 8] |= 1
    path.write_bytes(encrypted)
    reasons = {row.student: row.reason for row in read_class(path, PROBLEM, None)}
    assert "encrypted" in reasons["ann"]


def test_a_zip_with_random_faults_is_never_a_traceback(tmp_path: Path) -> None:
    path = class_of(tmp_path, {f"ann {n}/é.py": PROGRAM * 20 for n in range(3)}, "zip")
    content, chance = path.read_bytes(), random.Random(11)
    for _ in range(300):
        damaged = bytearray(content)
        for _ in range(chance.randrange(1, 6)):
            damaged[chance.randrange(4, len(damaged))] = chance.randrange(256)
        path.write_bytes(damaged)
        with suppress(ClassError):
            read_class(path, PROBLEM, None)


def test_no_class(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "empty").mkdir()
    (tmp_path / "cut.zip").write_bytes(b"PK\x03\x04 and then nothing")
    for name, words in (("empty", "found no files"), ("cut.zip", "found a damaged one")):
        with pytest.raises(ClassError, match=words):
            read_class(tmp_path / name, PROBLEM, None)
    assert not is_class(ROOT / "solution.py")
    assert not is_class(tmp_path / "none")
    os.mkfifo(tmp_path / "pipe")
    assert not is_class(tmp_path / "pipe"), "it must not be opened"
    many = class_of(tmp_path, {f"{n}.py": PROGRAM for n in range(5)}, "directory")
    monkeypatch.setattr("judge.batch.entries.MOST_FILES", 4)
    with pytest.raises(ClassError, match="at most 4 files"), entries_of(many):
        assert MOST_FILES > 4


def test_metadata_that_is_no_yaml_names_nobody() -> None:
    assert students("\0\n: :\nsubmission_1:\n  - x\n    name:\n") == {}
    assert students(METADATA)["submission_124"] == "Zoë"
