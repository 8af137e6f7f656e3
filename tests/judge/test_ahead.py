"""After two runs alike, the wall of the next one is built ahead; its program waits."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from judge.sandbox.facts import Stop
from judge.sandbox.keeper.proc import descendants, read

if TYPE_CHECKING:
    from tests.judge.conftest import RunPython

COPY = "import os; os.write(1, os.read(0, 99)); print(os.getppid()) # {mark}"


@pytest.fixture
def mark() -> str:
    """What only the programs of one test hold in their command line."""
    return f"mark-{os.getpid()}-{time.monotonic_ns()}"


@pytest.fixture
def run(run_walled: RunPython, tmp_path: Path, mark: str):
    """Feed a text to a program that repeats it, behind the wall; return what it wrote."""

    def once(text: str, **limits: float) -> str:
        (tmp_path / "in").write_text(text)
        facts = run_walled(COPY.format(mark=mark), stdin=tmp_path / "in", **limits)
        assert (facts.exit_status, facts.stopped) == (0, None)
        return (tmp_path / "out").read_text()

    return once


def marked(mark: str) -> list[int]:
    """Return the processes of a wall: bubblewrap twice, and the shell or the program."""
    return [pid for pid in descendants() if mark in read(f"/proc/{pid}/cmdline")]


def shells(mark: str) -> list[int]:
    """Return the shells that wait to become a program."""
    return [pid for pid in marked(mark) if read(f"/proc/{pid}/comm") == "sh\n"]


def wait_for_shells(mark: str, number: int) -> list[int]:
    give_up = time.monotonic() + 20
    while len(found := shells(mark)) != number and time.monotonic() < give_up:
        time.sleep(0.01)
    assert len(found) == number
    return found


def test_the_third_run_alike_gets_the_wall_that_waits(run, mark: str) -> None:
    assert run("1\n") == "1\n1\n"
    time.sleep(0.1)
    assert shells(mark) == []  # one run says nothing about the next
    for text in ("", "2\n", "\n\n3"):
        assert run(text) == text + "1\n"  # nothing is lost or added
        waits = wait_for_shells(mark, 1)
    run("4")
    assert wait_for_shells(mark, 1) != waits


def test_another_command_ends_the_wall_that_waits(
    run, run_walled, mark: str, tmp_path: Path
) -> None:
    run("1")
    run("2")
    wait_for_shells(mark, 1)
    assert run_walled("print('another')").exit_status == 0
    assert (tmp_path / "out").read_text() == "another\n"
    assert shells(mark) == []
    run("1", memory_mib=150)
    run("2", memory_mib=150)
    wait_for_shells(mark, 1)
    run("3", memory_mib=151)  # another limit is another command
    assert shells(mark) == []


def test_a_wall_that_was_killed_while_it_waited_is_built_again(run, mark: str) -> None:
    run("1")
    run("2")
    for _ in range(2):
        (shell,) = wait_for_shells(mark, 1)
        os.kill(shell, signal.SIGKILL)
        while marked(mark):  # the wall itself ends, too
            time.sleep(0.01)
        assert run("3") == "31\n"


def test_what_waits_is_held_by_the_same_limits(run_walled: RunPython, tmp_path: Path) -> None:
    code = (
        "import resource\n"
        "names = [name for name in dir(resource) if name.startswith('RLIMIT_')]\n"
        "print(*[resource.getrlimit(getattr(resource, name)) for name in names])\n"
    )
    found = set()
    for _ in range(3):
        assert run_walled(code).exit_status == 0
        found.add((tmp_path / "out").read_text())
    assert len(found) == 1
    for _ in range(3):
        assert run_walled("while True: pass", time_limit_s=0.2).stopped is Stop.CPU
    for _ in range(3):
        facts = run_walled("import time; time.sleep(0.05)")
        assert facts.cpu_s < 0.2
        assert facts.elapsed_s > 0.05
