"""The command: which targets, what it writes and says, and what it refuses."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from export.cli import main
from export.files import Files
from export.package import ExportError, Package
from export.target import Target
from export.targets import TARGETS
from export.verify.cli import VERIFIERS
from export.write import chosen, write


def test_the_list_names_every_target(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == list(TARGETS)


def test_an_unknown_target_gets_a_suggestion(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["katis"]) == 2
    assert "did you mean 'kattis'?" in capsys.readouterr().err


def test_each_target_is_chosen_once() -> None:
    assert [target.name for target in chosen(["plain", "kattis", "plain"])] == ["plain", "kattis"]
    assert len(chosen(["all"])) == len(TARGETS)


def test_each_verifier_has_a_target() -> None:
    assert set(VERIFIERS) <= set(TARGETS)


def test_where_a_package_is_and_what_to_do_with_it(
    package: Package,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr("export.cli.load_package", lambda **_compact: package)
    assert main(["plain", "--output", str(tmp_path)]) == 0
    out = capsys.readouterr().out
    assert f"{tmp_path / 'plain.zip'}: " in out
    assert TARGETS["plain"].import_it in out
    assert [path.name for path in tmp_path.iterdir()] == ["plain.zip"]


def test_a_package_that_is_too_large_is_not_left(package: Package, tmp_path: Path) -> None:
    target = replace(TARGETS["plain"], max_bytes=1000)
    with pytest.raises(ExportError, match="at most"):
        write(target, package, tmp_path)
    assert not list(tmp_path.iterdir())


def test_a_directory_is_written_as_one(package: Package, tmp_path: Path) -> None:
    def build(_package: Package) -> Files:
        files = Files()
        files.add("a/b", b"1")
        return files

    target = Target("d", "", build, "", directory=True)
    write(target, package, tmp_path)
    assert (tmp_path / "d" / "a" / "b").read_bytes() == b"1"
