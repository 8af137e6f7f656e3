"""When a run is repeated: never for how a program ended, once for what the kernel did."""

from __future__ import annotations

from pathlib import Path

import pytest

from judge.sandbox.facts import Facts, RunLimits, Stop
from judge.sandbox.keeper.tree import REAP_TIMEOUT_S
from judge.sandbox.keepers import ANSWER_MARGIN_S, LostKeeperError, SandboxError
from judge.sandbox.sandbox import Command, Sandbox, out_of_memory_kills

FINE = Facts(0, None, 0.1, 0.1, 9.0, 0, None)
KILLED = FINE._replace(exit_status=None, signal=9)
KILLED_INSIDE = FINE._replace(exit_status=137)
STOPPED = KILLED._replace(stopped=Stop.CPU)
CRASHED = FINE._replace(exit_status=139)
LIMITS = RunLimits(time_limit_s=5.0, memory_mib=100, output_mib=1)
COMMAND = Command(("/bin/true",))


@pytest.mark.parametrize(
    ("first", "kernel_kills", "runs"),
    [
        (FINE, 1, 1),
        (CRASHED, 1, 1),
        (STOPPED, 1, 1),
        (KILLED, 0, 1),  # by itself: a program that gives up so gets no other try
        (KILLED_INSIDE, 0, 1),
        (KILLED, 1, 2),
        (KILLED_INSIDE, 1, 2),
        (LostKeeperError(), 1, 2),
    ],
)
def test_a_repeat_needs_evidence(
    sandbox: Sandbox,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    first: Facts | Exception,
    kernel_kills: int,
    runs: int,
) -> None:
    made: list[object] = []

    def run(*_: object) -> Facts:
        made.append(None)
        if len(made) > 1:
            return FINE
        if isinstance(first, Exception):
            raise first
        return first

    monkeypatch.setattr(sandbox, "_run", run)
    kills = iter(range(0, 99, kernel_kills) if kernel_kills else [0] * 99)
    monkeypatch.setattr("judge.sandbox.sandbox.out_of_memory_kills", lambda: next(kills))
    facts = sandbox.run(COMMAND, LIMITS, stdout=tmp_path / "out")
    assert facts == (first if runs == 1 else FINE)
    assert len(made) == runs


@pytest.mark.parametrize("error", [SandboxError("no scratch space"), LostKeeperError()])
def test_a_failure_without_evidence_is_final(
    sandbox: Sandbox, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    made: list[object] = []

    def run(*_: object) -> Facts:
        made.append(None)
        raise error

    monkeypatch.setattr(sandbox, "_run", run)
    monkeypatch.setattr("judge.sandbox.sandbox.out_of_memory_kills", lambda: 7)
    with pytest.raises(type(error)):
        sandbox.run(COMMAND, LIMITS, stdout=tmp_path / "out")
    assert len(made) == 1


@pytest.mark.parametrize("killed", [KILLED, KILLED_INSIDE])
def test_a_compiler_that_something_killed_is_no_compile_error(
    sandbox: Sandbox, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, killed: Facts
) -> None:
    monkeypatch.setattr(sandbox, "_run", lambda *_: killed)
    with pytest.raises(SandboxError, match="something killed the compiler"):
        sandbox.run(COMMAND, LIMITS, stdout=tmp_path / "out", compiling=True)
    assert sandbox.run(COMMAND, LIMITS, stdout=tmp_path / "out") == killed


def test_the_judge_waits_longer_than_a_starving_run_may_take() -> None:
    assert ANSWER_MARGIN_S > REAP_TIMEOUT_S


def test_the_kernels_count_is_read(tmp_path: Path) -> None:
    (tmp_path / "vmstat").write_text("pgfault 12\noom_kill 34\nunevictable 5\n")
    assert out_of_memory_kills(tmp_path / "vmstat") == 34
    assert out_of_memory_kills(tmp_path / "none") == 0
    assert out_of_memory_kills() >= 0
