"""Parts of the judge are killed at random moments: at worst a judge error; nothing is left."""

from __future__ import annotations

import ctypes
import json
import os
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from judge.kit.paths import ROOT
from judge.sandbox.keeper.proc import children, fields
from judge.sandbox.wall import Wall

PR_SET_CHILD_SUBREAPER = 36
LONGEST_MOMENT_S = 1.2  # by then, the judging of these cases is over or nearly so
ECHO = "import sys, time\ntime.sleep(0.1)\nsys.stdout.write(sys.stdin.read())\n"

_random = random.Random(3)
FAST_ROUNDS = 2  # of each victim; the others are slow ones
ROUNDS = [
    pytest.param(
        victim,
        round(_random.random() * LONGEST_MOMENT_S, 3),
        marks=[pytest.mark.slow] if number >= FAST_ROUNDS else [],
    )
    for victim in ("keeper", "wall", "first process", "checker")
    for number in range(5)
]


@pytest.fixture(autouse=True)
def no_process_is_left(wall: Wall) -> Iterator[None]:
    """Adopt every process that outlives the checker, so that it is found."""
    assert wall
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1)
    before = alive()
    yield
    give_up = time.monotonic() + 20
    while alive() - before and time.monotonic() < give_up:
        time.sleep(0.02)
    assert not alive() - before, "processes were left"


def alive() -> set[int]:
    """Return the living children. Zombies are left out: nobody but this process reaps them."""
    states = {pid: fields(f"/proc/{pid}")[:1] for pid in children(os.getpid())}
    return {pid for pid, state in states.items() if state not in ([], ["Z"])}


def find(victim: str, checker: int) -> int | None:
    """Return the process that is the `victim` now, None if there is none yet."""
    generation = [checker]
    for _ in range(["checker", "keeper", "wall", "first process"].index(victim)):
        generation = [child for pid in generation for child in children(pid)]
    return generation[0] if generation else None


@pytest.mark.parametrize(("victim", "moment_s"), ROUNDS)
def test_a_killed_part_changes_no_verdict_and_leaves_nothing(
    victim: str, moment_s: float, source: Callable[[str, str], Path], data: Path, tmp_path: Path
) -> None:
    scratch, report = tmp_path / "scratch", tmp_path / "report.json"
    scratch.mkdir()
    command = [sys.executable, str(ROOT / "checker.py"), str(source("echo.py", ECHO))]
    options = ["--data", str(data), "--jobs", "2", "--time-limit", "5", "--all"]
    options += ["--json", str(report)]
    with subprocess.Popen(
        [*command, *options],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "TMPDIR": str(scratch)},
    ) as process:
        time.sleep(moment_s)
        pid = None
        while pid is None and process.poll() is None:  # until the victim has started
            pid = find(victim, process.pid)
        if pid is not None:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pid = None  # it has just ended
        _, stderr = process.communicate(timeout=60)
    assert "Traceback" not in stderr
    if pid == process.pid:
        assert process.returncode == -signal.SIGKILL
    # To the judge, it looks as if the program had killed itself, which is no reason to repeat it.
    permitted = {"AC", "JE", *(["RTE"] if victim == "first process" else [])}
    if pid != process.pid:
        assert process.returncode in (0, 2, *([1] if "RTE" in permitted else [])), stderr
    if report.exists():
        judged = json.loads(report.read_text())
        assert {judged["verdict"], *(case["verdict"] for case in judged["cases"])} <= permitted
    give_up = time.monotonic() + 20
    while list(scratch.iterdir()) and time.monotonic() < give_up:
        time.sleep(0.02)
    assert list(scratch.iterdir()) == [], "files were left"
