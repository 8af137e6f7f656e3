"""Trees of files: safe names, equal bytes, whole or not at all."""

from __future__ import annotations

import os
import zipfile
from pathlib import Path

import pytest

from export.files import Files, FilesError


@pytest.mark.parametrize(
    "name", ["a b", "-a", "a/../b", "/a", "a//b", "a/", "é", "", ".hidden", "a/.x"]
)
def test_names_that_a_judge_would_refuse(name: str) -> None:
    with pytest.raises(FilesError):
        Files().add(name, b"")


def test_a_name_occurs_once() -> None:
    files = Files()
    files.add("a/b", b"1")
    with pytest.raises(FilesError, match="twice"):
        files.add("a/b", b"2")


def test_equal_trees_give_equal_zips(tmp_path: Path) -> None:
    source = tmp_path / "source"
    source.write_bytes(b"from a file")
    contents = []
    for order in (("b", "a"), ("a", "b")):
        os.utime(source, (len(contents), len(contents)))
        files = Files()
        for name in order:
            files.add(name, {"a": source, "b": b"in memory"}[name])
        files.write_zip(tmp_path / "x.zip")
        contents.append((tmp_path / "x.zip").read_bytes())
        assert contents[-1] == files.as_zip()
    assert contents[0] == contents[1]


def test_a_zip_keeps_content_and_mode(tmp_path: Path) -> None:
    files = Files()
    files.add("run", "#!/bin/sh\n", executable=True)
    files.add("d/text", "é\n")
    files.write_zip(tmp_path / "deep" / "x.zip")
    with zipfile.ZipFile(tmp_path / "deep" / "x.zip") as archive:
        assert archive.read("d/text").decode() == "é\n"
        modes = {info.filename: info.external_attr >> 16 & 0o777 for info in archive.infolist()}
    assert modes == {"run": 0o755, "d/text": 0o644}


def test_nothing_is_left_of_a_package_that_fails(tmp_path: Path) -> None:
    files = Files()
    files.add("a", b"1")
    files.add("gone", tmp_path / "gone")
    (tmp_path / "out" / "d").mkdir(parents=True)
    (tmp_path / "out" / "d" / "old").touch()
    (tmp_path / "out" / "x.zip").write_bytes(b"old")
    with pytest.raises(OSError, match="gone"):
        files.write_zip(tmp_path / "out" / "x.zip")
    with pytest.raises(OSError, match="gone"):
        files.write_directory(tmp_path / "out" / "d")
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["d", "x.zip"]
    assert (tmp_path / "out" / "x.zip").read_bytes() == b"old"
    assert (tmp_path / "out" / "d" / "old").exists()


def test_a_directory_replaces_what_was_there(tmp_path: Path) -> None:
    (tmp_path / "d").mkdir()
    (tmp_path / "d" / "old").touch()
    files = Files()
    files.add("new/run", b"1", executable=True)
    files.write_directory(tmp_path / "d")
    assert [path.name for path in tmp_path.iterdir()] == ["d"]
    assert [path.name for path in (tmp_path / "d").iterdir()] == ["new"]
    assert (tmp_path / "d" / "new" / "run").stat().st_mode & 0o777 == 0o755
