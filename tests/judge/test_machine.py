"""The speed of a machine: measured until two runs agree, kept while the machine is the same."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import msgspec
import pytest

from judge import machine
from judge.kit.processors import cores
from judge.machine import (
    MOST_RUNS,
    MachineError,
    forget_scale,
    kept_scale,
    measure_scale,
    reference_cpu_s,
)
from judge.problem.cases import Case
from judge.problem.declaration import load
from judge.problem.verdict import Verdict
from judge.results import CaseResult

PROBLEM = load()
DECLARED_S = PROBLEM.calibration.reference_cpu_s
Times = Callable[..., list[float]]


@pytest.fixture
def times(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Times:
    """Let runs of the reference take these CPU seconds, one after the other, on a tiny case."""
    (tmp_path / "case.in").write_text("YES\n")
    (tmp_path / "case.ans").write_text("YES\n")
    case = Case("case", ".", tmp_path / "case.in", tmp_path / "case.ans")

    def script(*cpu_s: float, verdict: Verdict = Verdict.AC) -> list[float]:
        left = list(cpu_s)
        monkeypatch.setattr(machine, "calibration_case", lambda _problem: case)
        monkeypatch.setattr(machine, "compile_submission", lambda *_: SimpleNamespace())
        monkeypatch.setattr(
            machine,
            "run_case",
            lambda *_: CaseResult(case, verdict, left.pop(0), 1.0, 1.0, "so"),
        )
        return left

    return script


@pytest.mark.parametrize(
    ("cpu_s", "enough_s", "found_s", "left"),
    [
        ((0.31, 0.30, 0.302, 9.0), 0.0, 0.30, 1),  # the two fastest of three agree
        ((0.40, 0.35, 0.30, 0.31, 0.301, 9.0), 0.0, 0.30, 1),  # not before the fifth
        ((0.40, 0.25, 9.0), 0.27, 0.25, 1),  # fast enough: no further run
        (tuple(1.0 / n for n in range(1, 40)), 0.0, 1 / MOST_RUNS, 39 - MOST_RUNS),
    ],
)
def test_how_often_the_reference_is_timed(
    times: Times, cpu_s: tuple[float, ...], enough_s: float, found_s: float, left: int
) -> None:
    unused = times(*cpu_s)
    assert reference_cpu_s(PROBLEM, None, enough_s) == found_s  # type: ignore[arg-type] # not used
    assert len(unused) == left


def test_a_reference_that_fails_is_an_error(times: Times) -> None:
    times(1.0, verdict=Verdict.WA)
    with pytest.raises(MachineError, match="the reference is not accepted on case: WA so"):
        reference_cpu_s(PROBLEM, None)  # type: ignore[arg-type] # not used


def measured(path: Path) -> float:
    scale = measure_scale(PROBLEM, None, path)  # type: ignore[arg-type] # not used
    assert scale is not None
    assert scale.source.startswith("measured now")
    return scale.factor


def test_the_scale_is_kept_for_this_machine_only(times: Times, tmp_path: Path) -> None:
    path = tmp_path / "build" / "machine.json"
    assert kept_scale(PROBLEM, path) is None
    times(*[1.5 * DECLARED_S] * 3)
    assert measured(path) == 1.5
    kept = kept_scale(PROBLEM, path)
    assert kept is not None
    assert (kept.factor, kept.source.startswith("measured on 2")) == (1.5, True)
    content = msgspec.json.decode(path.read_bytes())
    for key in content["machine"]:
        other = {**content["machine"], key: 7 if key.endswith("_s") else "another"}
        path.write_bytes(msgspec.json.encode({**content, "machine": other}))
        assert kept_scale(PROBLEM, path) is None, key
    for broken in (b"", b"{}", b"\xff"):
        path.write_bytes(broken)
        assert kept_scale(PROBLEM, path) is None
    forget_scale(path)
    forget_scale(path)
    assert not path.exists()


def test_a_faster_machine_does_not_lower_the_limit(times: Times, tmp_path: Path) -> None:
    times(DECLARED_S / 2)
    assert measured(tmp_path / "machine.json") == 1.0


def test_a_scale_that_cannot_be_kept_is_used_all_the_same(times: Times, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    times(*[2 * DECLARED_S] * 3)
    assert measured(tmp_path / "file" / "machine.json") == 2.0


def test_without_the_calibration_case_there_is_no_scale(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    case = Case("none", ".", tmp_path / "none.in", tmp_path / "none.ans")
    monkeypatch.setattr(machine, "calibration_case", lambda _problem: case)
    assert measure_scale(PROBLEM, None, tmp_path / "kept") is None  # type: ignore[arg-type] # not used


def test_without_the_reference_there_is_no_scale(
    times: Times, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """As in a kit for students."""
    times(2 * DECLARED_S, 2 * DECLARED_S, 2 * DECLARED_S)
    monkeypatch.setattr(machine, "REFERENCE", tmp_path / "none.py")
    assert measure_scale(PROBLEM, None, tmp_path / "kept") is None  # type: ignore[arg-type] # not used


def test_cores_are_counted_by_what_the_kernel_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("os.sched_getaffinity", lambda _pid: {0, 1, 2, 3, 6})
    assert cores(tmp_path) == 2  # the kernel tells nothing: two processors share a core
    for processor, siblings in enumerate(("0,4", "1,5", "2,6", "3,7", "0,4", "1,5", "2,6", "3,7")):
        directory = tmp_path / f"cpu{processor}" / "topology"
        directory.mkdir(parents=True)
        (directory / "thread_siblings_list").write_text(f"{siblings}\n")
    assert cores(tmp_path) == 4  # 2 and 6 share one
    monkeypatch.setattr("os.sched_getaffinity", lambda _pid: {5})
    assert cores(tmp_path) == 1
