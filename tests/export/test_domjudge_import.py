"""DOMjudge's own importer reads the package. Slow, and only with php and a checkout of DOMjudge."""

from __future__ import annotations

import os
import subprocess
import zipfile
from pathlib import Path

import msgspec
import pytest

from export.package import load_package
from export.targets import TARGETS
from export.verify import domjudge
from export.verify.domjudge import CHECKOUT, HARNESS, missing, read_back, verify
from export.verify.job import VerifyError

needs_domjudge = pytest.mark.skipif(bool(missing()), reason=missing() or "it is here")


@pytest.fixture(scope="module")
def checkout() -> Path:
    return Path(os.environ[CHECKOUT])


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("package") / "collisioncourse.zip"
    TARGETS["domjudge"].build(load_package(compact=True)).write_zip(path)
    return path


def changed(package: Path, path: Path, name: str, old: bytes, new: bytes) -> Path:
    """Write a copy of a zip, without the large cases, in which one file differs."""
    with zipfile.ZipFile(package) as source, zipfile.ZipFile(path, "w") as target:
        for entry in source.namelist():
            if "3-large" in entry or "4-many" in entry:
                continue
            content = source.read(entry)
            assert entry != name or old in content
            target.writestr(entry, content.replace(old, new) if entry == name else content)
    return path


@pytest.mark.slow
@needs_domjudge
def test_the_importer_has_nothing_to_say(package: Path, tmp_path: Path, checkout: Path) -> None:
    told = verify(package, tmp_path, checkout)
    assert told[0].startswith("DOMjudge's importer: no warning; collisioncourse: 5 s, 524288 KiB")
    assert told[1].startswith("4 sample and ")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
@needs_domjudge
@pytest.mark.parametrize(
    ("name", "old", "new", "message"),
    [
        (
            "problem.yaml",
            b"Collision Course",
            b"''",
            "problem.name: This value should not be blank",
        ),
        (".timelimit", b"5", b"9", "Conflicting time limits"),
        ("problem.yaml", b"memory: 512", b"memory: 256", "memory limit: expected 524288, found"),
        (
            "submissions/wrong_answer/strict_touch.py",
            b": WRONG_ANSWER",
            b": RUN_TIME_ERROR",
            "Annotated result 'RUN-ERROR' does not match directory",
        ),
        ("data/sample/01-first.in", b"\n", b"\r\n", "contains Windows newlines"),
    ],
)
def test_faults_of_a_package_are_told(
    package: Path, tmp_path: Path, checkout: Path, name: str, old: bytes, new: bytes, message: str
) -> None:
    wrong = changed(package, tmp_path / "collisioncourse.zip", name, old, new)
    with pytest.raises(VerifyError, match=message):
        verify(wrong, tmp_path, checkout)


@pytest.mark.slow
@needs_domjudge
def test_groups_of_the_legacy_format_are_parsed(tmp_path: Path, checkout: Path) -> None:
    """DOMjudge's parser takes the points; it knows no `accept_if_any_accepted` and says so."""
    files = TARGETS["kattis"].build(load_package(compact=True))
    for name in (name for name in files.entries if name.endswith("testdata.yaml")):
        path = tmp_path / "testdata.yaml"
        path.write_bytes(files.entries[name].read())
        command = ["php", str(HARNESS), str(checkout), "--test-group", str(path)]
        done = subprocess.run(command, capture_output=True, check=True)
        found = msgspec.json.decode(done.stdout)
        warnings = found["messages"]["warning"] if found["messages"] else []
        assert [text for text in warnings if "accept_if_any_accepted" not in text] == []
        if name.endswith("3-large/testdata.yaml"):
            assert (found["aggregation"], float(found["accept_score"])) == ("min", 50.0)


def test_what_is_missing_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(domjudge.shutil, "which", lambda _name: None)
    assert "apt install php-cli" in missing()
    monkeypatch.setattr(domjudge.shutil, "which", lambda _name: "/usr/bin/php")
    monkeypatch.delenv(CHECKOUT, raising=False)
    assert missing().startswith(f"{CHECKOUT} is not set")
    monkeypatch.setenv(CHECKOUT, str(tmp_path))
    assert "found no webapp/src/Service/ImportProblemService.php" in missing()


def test_a_crash_of_php_is_one_line(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def crash(command: list[str], **_options: object) -> subprocess.CompletedProcess[bytes]:
        return subprocess.CompletedProcess(command, 255, b"", b"PHP Fatal error: x\nStack trace\n")

    monkeypatch.setattr(domjudge.subprocess, "run", crash)
    with pytest.raises(VerifyError, match=r"^php: PHP Fatal error: x$"):
        read_back(tmp_path / "a.zip", tmp_path, tmp_path)
