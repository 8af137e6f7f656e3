"""Small data and small programs for the tests of the judge."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from judge.facts import Facts, RunLimits
from judge.sandbox import Command, Sandbox

ROOT = Path(__file__).resolve().parents[2]
Checker = Callable[..., subprocess.CompletedProcess[str]]
RunPython = Callable[..., Facts]


def write_case(directory: Path, name: str, text: str, answer: str) -> None:
    path = directory / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.with_name(path.name + ".in").write_text(text)
    path.with_name(path.name + ".ans").write_text(answer)


@pytest.fixture
def data(tmp_path: Path) -> Path:
    """Three groups; the input of each case is its answer."""
    directory = tmp_path / "data"
    write_case(directory, "sample/01", "YES\n", "YES\n")
    write_case(directory, "secret/static/01", "NO\nYES\n", "NO\nYES\n")
    write_case(directory, "secret/small/01", "YES\nYES\n", "YES\nYES\n")
    write_case(directory, "secret/small/02", "NO\nNO\nYES\n", "NO\nNO\nYES\n")
    return directory


@pytest.fixture
def source(tmp_path: Path) -> Callable[[str, str], Path]:
    """Write a source file and return its path."""

    def write(name: str, text: str) -> Path:
        path = tmp_path / name
        path.write_text(text)
        return path

    return write


@pytest.fixture
def checker(tmp_path: Path) -> Checker:
    """Run checker.py from a foreign directory, with scratch files where a test can count them."""
    scratch = tmp_path / "scratch"
    scratch.mkdir()

    def run(*arguments: object, **options: object) -> subprocess.CompletedProcess[str]:
        settings: dict[str, object] = {
            "capture_output": True,
            "text": True,
            "timeout": 120,
            "cwd": tmp_path,
            "env": {**os.environ, "TMPDIR": str(scratch)},
        }
        if "input" not in options:
            settings["stdin"] = subprocess.DEVNULL
        command = [sys.executable, str(ROOT / "checker.py"), *map(str, arguments)]
        done = subprocess.run(command, **(settings | options))  # type: ignore[call-overload] # a dict of keywords
        assert "Traceback" not in done.stderr
        assert list(scratch.iterdir()) == [], "scratch files were left"
        return done

    return run


@pytest.fixture(scope="session")
def sandbox() -> Iterator[Sandbox]:
    with Sandbox() as box:
        yield box


@pytest.fixture
def run_python(sandbox: Sandbox, tmp_path: Path) -> RunPython:
    """Run Python code in the sandbox; its output lands in `tmp_path / "out"`."""

    def run(code: str, stdin: Path | None = None, **limits: float) -> Facts:
        command = Command((os.path.realpath(sys.executable), "-I", "-S", "-c", code))
        allowed = RunLimits(
            time_limit_s=limits.get("time_limit_s", 5),
            memory_mib=int(limits.get("memory_mib", 200)),
            output_mib=int(limits.get("output_mib", 1)),
            processes=int(limits.get("processes", 32)),
        )
        return sandbox.run(command, allowed, stdin=stdin, stdout=tmp_path / "out")

    return run
