"""Names and files are data: whatever they are called, and whatever stands at their path."""

from __future__ import annotations

import os
import pty
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from judge.judging import JudgeError, Options, judge
from judge.kit.paths import REFERENCE, ROOT
from judge.languages.submission import SubmissionError, read_submission
from judge.problem.declaration import load

PROBLEM = load()
ECHO = "import sys\nsys.stdout.write(sys.stdin.read())\n"
Source = Callable[[str, str], Path]
NAMES = ["[link=file:x]", "\\[", "\u202eyp"]
MORE_NAMES = ["[", "[x]", "[red]", "[bold", ":smile:", "&amp;<b>"]


@pytest.mark.parametrize(
    "name", [*NAMES, *(pytest.param(name, marks=pytest.mark.slow) for name in MORE_NAMES)]
)
def test_a_name_is_shown_as_it_is(source: Source, data: Path, name: str) -> None:
    """On a terminal too, where a library could take it for markup."""
    for ending in (".in", ".ans"):
        (data / f"secret/{name}").mkdir(exist_ok=True)
        (data / f"secret/{name}/1{ending}").write_text("YES\n")
    path = source(f"{name}.py", ECHO)
    reports = [data.parent / "r.json", data.parent / "r.xml"]
    command = [sys.executable, ROOT / "checker.py", path, "--data", data, "--no-wall"]
    command += ["--json", reports[0], "--junit", reports[1]]
    shown = name if name.isprintable() else name.encode("unicode_escape").decode()
    reader, terminal = pty.openpty()
    with subprocess.Popen(command, stdout=terminal, stderr=subprocess.PIPE, text=True) as process:
        os.close(terminal)
        said = b""
        while block := _read(reader):
            said += block
        assert process.stderr is not None
        assert process.stderr.read() == ""
    os.close(reader)
    assert process.returncode == 0
    text = said.decode()
    assert f"secret/{shown}/1" in text
    assert f"{shown}.py (Python 3)" in text
    assert all(report.stat().st_size > 0 for report in reports)


def _read(terminal: int) -> bytes:
    try:
        return os.read(terminal, 1 << 16)
    except OSError:  # the other end is closed
        return b""


def test_what_is_no_file_is_refused_at_once(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.py")
    for path, kind in ((tmp_path / "pipe.py", "a pipe"), (Path("/dev/zero"), "a device")):
        with pytest.raises(SubmissionError, match=f"expected a source file, found {kind}"):
            read_submission(path)


@pytest.mark.skipif(os.getuid() != 0, reason="only root can give a link to somebody else")
def test_a_link_to_a_file_of_another_user_is_not_followed(source: Source, tmp_path: Path) -> None:
    target, link = source("secret.py", "the first line\n"), tmp_path / "mine.py"
    link.symlink_to(target)
    assert read_submission(link).source == b"the first line\n"
    os.lchown(link, 65534, 65534)
    with pytest.raises(SubmissionError, match="expected a link to a file of its owner"):
        read_submission(link)


def test_a_path_that_is_swapped_is_not_vouched_for(
    source: Source, data: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("judge.sandbox.probe.candidates", lambda *_: [])
    path = source("mine.py", ECHO)
    submission = read_submission(path)
    path.unlink()
    path.symlink_to(REFERENCE)
    with pytest.raises(JudgeError, match="no wall works here"):
        judge(submission, PROBLEM, Options(data=data, time_limit_s=5.0))
    copy = source("copy.py", REFERENCE.read_text())
    with pytest.raises(JudgeError, match="no wall works here"):
        judge(read_submission(copy), PROBLEM, Options(data=data, time_limit_s=5.0))


def test_the_kits_own_programs_are_vouched_for_by_any_path(
    tmp_path: Path, data: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("judge.sandbox.probe.candidates", lambda *_: [])
    link = tmp_path / "link.py"
    link.symlink_to(REFERENCE)
    shutil.rmtree(data / "secret")
    outcome = judge(read_submission(link), PROBLEM, Options(data=data, time_limit_s=5.0))
    assert outcome.wall is None
