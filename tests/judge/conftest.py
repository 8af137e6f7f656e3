"""Small data and small programs for the tests of the judge."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import msgspec
import pytest

from judge.kit.paths import ROOT
from judge.problem.declaration import Feedback, load
from judge.sandbox.facts import Facts, RunLimits
from judge.sandbox.keeper.cgroup import Cgroups
from judge.sandbox.probe import NoWallError
from judge.sandbox.probe import walled_sandbox as find_wall
from judge.sandbox.sandbox import Command, Sandbox
from judge.sandbox.wall import Wall

Checker = Callable[..., subprocess.CompletedProcess[str]]
RunPython = Callable[..., Facts]

# Without a diagnosis, which runs a program that is not accepted some hundred times more.
QUIET = msgspec.structs.replace(load(), feedback=Feedback(tell="verdict", name_secret_cases=True))
# Wrong, but in step with the gallery, so that its diagnosis takes few runs.
WRONG = "first = input()\nprint('YES\\n' * int(first) if first.isdigit() else 'YES')\n"


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
    """Run checker.py from another directory, with its scratch files where a test can see them."""
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
        # The tests' own programs are trusted, even where no wall works.
        command = [sys.executable, str(ROOT / "checker.py"), "--no-wall", *map(str, arguments)]
        done = subprocess.run(command, **(settings | options))  # type: ignore[call-overload] # a dict of keywords
        assert "Traceback" not in done.stderr
        assert list(scratch.iterdir()) == [], "scratch files were left"
        return done

    return run


@pytest.fixture(scope="session")
def sandbox() -> Iterator[Sandbox]:
    """A sandbox without a wall: only the keeper limits programs."""
    with Sandbox() as box:
        yield box


@pytest.fixture(scope="session")
def wall() -> Wall:
    """The wall that works on this machine."""
    try:
        with find_wall() as box:
            assert box.wall is not None
            return box.wall
    except NoWallError as error:
        pytest.skip(f"no wall works on this machine: {error}")


@pytest.fixture(scope="session")
def walled_sandbox(wall: Wall) -> Iterator[Sandbox]:
    with Sandbox(wall) as box:
        yield box


@pytest.fixture(scope="session")
def uncounted_sandbox(wall: Wall) -> Iterator[Sandbox]:
    """With a wall, and without control groups, as where a user may make none."""
    with Sandbox(wall, cgroups=Cgroups(None)) as box:
        yield box


def python_runner(sandbox: Sandbox, out: Path) -> RunPython:
    """Return a function that runs Python code in the sandbox; its output lands in `out`."""

    def run(code: str, stdin: Path | None = None, **limits: float) -> Facts:
        python = os.path.realpath(sys.executable)
        argv = (python, "-I", "-S", "-c", code)
        prefixes = () if python.startswith("/usr/") else (str(Path(python).parent.parent),)
        allowed = RunLimits(
            time_limit_s=limits.get("time_limit_s", 5),
            memory_mib=int(limits.get("memory_mib", 200)),
            output_mib=int(limits.get("output_mib", 1)),
            processes=int(limits.get("processes", 32)),
            elapsed_s=limits.get("elapsed_s"),
        )
        return sandbox.run(Command(argv, prefixes=prefixes), allowed, stdin=stdin, stdout=out)

    return run


@pytest.fixture(
    params=[
        "walled_sandbox",
        "uncounted_sandbox",  # the keeper samples, as without a wall
        pytest.param("sandbox", marks=pytest.mark.slow),
    ]
)
def run_python(request: pytest.FixtureRequest, tmp_path: Path) -> RunPython:
    """Run Python code behind the wall, there without control groups, and with the keeper alone."""
    return python_runner(request.getfixturevalue(request.param), tmp_path / "out")


@pytest.fixture
def run_bare(sandbox: Sandbox, tmp_path: Path) -> RunPython:
    return python_runner(sandbox, tmp_path / "out")


@pytest.fixture
def run_walled(walled_sandbox: Sandbox, tmp_path: Path) -> RunPython:
    return python_runner(walled_sandbox, tmp_path / "out")
