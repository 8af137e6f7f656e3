"""Calibration: the margins that given times leave, and how times are measured."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest

from judge.calibrate.cli import main, written
from judge.calibrate.margins import Time, margins, measure
from judge.judging import JudgeError
from judge.kit.paths import PROBLEM_FILE
from judge.problem.cases import Case
from judge.problem.declaration import load
from judge.problem.verdict import Verdict
from judge.results import CaseResult
from judge.sandbox.facts import RunLimits

PROBLEM = load()
ASKED = PROBLEM.limits.time_multipliers
Measured = tuple[list[Time], list[tuple[str, float]]]
Runs = Callable[..., Measured]


def time(expected: Verdict, cpu_s: float) -> Time:
    return Time(f"{expected}/{cpu_s}", "large", expected, "secret/large/01", cpu_s, False)


@pytest.mark.parametrize(
    ("slowest_s", "fastest_s", "declared_s", "proposal_s"),
    [
        (2.0, 9.0, 5.0, 5.0),  # the declared limit fits
        (2.0, 9.0, 7.0, 4.0),  # too long: too near the slow one
        (2.6, 9.0, 5.0, 5.5),  # too short for the accepted one: rounded up to half a second
        (2.5, 7.5, 5.0, 5.0),  # both margins are met exactly
        (3.1, 9.0, 5.0, None),  # no limit fits between the two
    ],
)
def test_proposal(
    slowest_s: float, fastest_s: float, declared_s: float, proposal_s: float | None
) -> None:
    times = [time(Verdict.AC, 0.1), time(Verdict.AC, slowest_s)]
    times += [time(Verdict.TLE, fastest_s), time(Verdict.TLE, 99.0)]
    found = margins(times, PROBLEM)
    assert (found.slowest.cpu_s, found.least_s) == (slowest_s, slowest_s * ASKED.ac_to_time_limit)
    assert found.most_s == fastest_s / ASKED.time_limit_to_tle
    assert found.proposal(declared_s) == proposal_s


def test_without_slow_submissions_the_limit_has_no_upper_bound() -> None:
    found = margins([time(Verdict.AC, 1.0)], PROBLEM)
    assert (found.fastest, found.most_s) == (None, math.inf)
    with pytest.raises(JudgeError, match="no accepted submission"):
        margins([time(Verdict.TLE, 1.0)], PROBLEM)


def test_only_the_two_figures_are_written(tmp_path: Path) -> None:
    text = PROBLEM_FILE.read_text()
    path = tmp_path / "problem.toml"
    path.write_text(written(text, 7.5, 0.31))
    changed = load(path)
    assert (changed.limits.time_limit_s, changed.calibration.reference_cpu_s) == (7.5, 0.31)
    lines = zip(text.splitlines(), path.read_text().splitlines(), strict=True)
    differing = [(old, new) for old, new in lines if old != new]
    assert [new.split()[0] for _, new in differing] == ["time_limit_s", "reference_cpu_s"]
    assert all(old.partition("#")[2] == new.partition("#")[2] for old, new in differing)
    with pytest.raises(JudgeError, match="expected one line `time_limit_s = …`, found 0"):
        written("", 1.0, 1.0)


def test_only_must_name_a_submission(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--only", "no such submission"]) == 2
    assert "expected part of a name" in capsys.readouterr().err


SLOW = "time_limit_exceeded/brute_force.cpp"


@pytest.fixture
def runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Runs:
    """Replace runs by a script: case -> size, verdict, CPU seconds; record cases and limits."""
    made: list[tuple[str, float]] = []

    def run(script: dict[str, tuple[int, Verdict, float]], name: str = SLOW) -> Measured:
        cases, told = [], []
        for case, (size, _, _) in script.items():
            path = tmp_path / case.replace("/", "-")
            path.write_bytes(b"x" * size)
            cases.append(Case(f"secret/{case}", case.partition("/")[0], path, path))

        def run_case(_box: object, _command: object, limits: RunLimits, case: Case) -> CaseResult:
            made.append((case.name, limits.time_limit_s))
            _, verdict, cpu_s = script[case.name.removeprefix("secret/")]
            return CaseResult(case, verdict, cpu_s, cpu_s, 1.0, "as the script says")

        monkeypatch.setattr("judge.calibrate.margins.run_case", run_case)
        times = measure(name, PROBLEM, cases, None, told.append)  # type: ignore[arg-type] # not used
        assert told == times
        return times, made

    program = SimpleNamespace(command=None)
    monkeypatch.setattr("judge.calibrate.margins.compile_submission", lambda *_: program)
    return run


def test_the_slowest_run_of_each_group_counts(runs: Runs) -> None:
    times, made = runs(
        {
            "small/short": (1, Verdict.AC, 0.5),
            "small/long": (9, Verdict.AC, 0.2),
            "large/short": (2, Verdict.AC, 0.3),
            "large/middle": (5, Verdict.TLE, 99.0),
            "large/long": (8, Verdict.AC, 7.0),
        }
    )
    assert times == [
        Time(SLOW, "small", Verdict.AC, "secret/small/short", 0.5, False),
        Time(SLOW, "large", Verdict.TLE, "secret/large/middle", 99.0, True),
    ]
    # The longest input runs first, and none after a run that was ended. The time limit of a run is
    # twice what is asked of slow submissions.
    bound_s = 2 * PROBLEM.limits.time_limit_s * ASKED.time_limit_to_tle
    names = ["small/long", "small/short", "large/long", "large/middle"]
    assert made == [(f"secret/{name}", bound_s) for name in names]


def test_a_submission_that_may_be_wrong_or_slow_is_not_timed(runs: Runs) -> None:
    either = {Verdict.WA, Verdict.TLE}
    name, group = next(
        (name, group)
        for name in PROBLEM.submissions
        for group in PROBLEM.group_names
        if PROBLEM.expected(name, group) == either
    )
    assert runs({f"{group}/1": (1, Verdict.TLE, 99.0)}, name) == ([], [])


@pytest.mark.parametrize(
    ("group", "found", "expected"),
    [("small", Verdict.TLE, "AC"), ("small", Verdict.WA, "AC"), ("large", Verdict.WA, "TLE")],
)
def test_an_undeclared_verdict_is_an_error(
    runs: Runs, group: str, found: Verdict, expected: str
) -> None:
    message = rf"brute_force\.cpp: secret/{group}/1: expected {expected}, found {found} \(as the"
    with pytest.raises(JudgeError, match=message):
        runs({f"{group}/1": (1, found, 1.0)})


@pytest.fixture
def calibrate(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Callable[..., tuple[int, str, list[str]]]:
    """Run the command line on a copy of problem.toml; every slow submission takes `slow_s`."""
    copy = tmp_path / "problem.toml"
    copy.write_bytes(PROBLEM_FILE.read_bytes())
    monkeypatch.setattr("judge.calibrate.cli.PROBLEM_FILE", copy)
    monkeypatch.setattr("judge.calibrate.cli.load", lambda: load(copy))
    no_cases = SimpleNamespace(chosen=())
    monkeypatch.setattr("judge.calibrate.cli.load_data", lambda *_, **__: no_cases)
    monkeypatch.setattr("judge.calibrate.cli.reference_cpu_s", lambda *_: 0.31234)
    monkeypatch.setattr("judge.calibrate.cli.forget_scale", lambda: None)

    def run(*arguments: str, slow_s: float) -> tuple[int, str, list[str]]:
        def measured(name: str, *others: object) -> list[Time]:
            slow = name.startswith("time_limit_exceeded/")
            verdict, cpu_s = (Verdict.TLE, slow_s) if slow else (Verdict.AC, 2.6)
            times = [Time(name, "large", verdict, "secret/large/01", cpu_s, slow)]
            others[-1](times[0])  # type: ignore[operator] # the callback `tell`
            return times

        monkeypatch.setattr("judge.calibrate.cli.measure", measured)
        before = copy.read_text().splitlines()
        status = main(arguments)
        lines = zip(before, copy.read_text().splitlines(), strict=True)
        return status, capsys.readouterr().out, [new for old, new in lines if old != new]

    return run


def test_a_limit_that_fits_is_written(calibrate) -> None:
    status, said, changed = calibrate("--write", slow_s=9.0)
    assert status == 0
    assert [line.partition("#")[0].strip() for line in changed] == [
        "time_limit_s = 5.5",
        "reference_cpu_s = 0.31",
    ]
    assert "0.31 s of CPU time" in said
    assert "AC     2.60 s  accepted/textbook.py  secret/large/01" in said
    assert f"TLE ≥  9.00 s  {SLOW}  secret/large/01" in said
    assert "wrong_answer" not in said
    slowest, limit, fastest = (
        next(line for line in said.splitlines() if line.strip().startswith(start) and "│" in line)
        for start in ("slowest AC", "limit", "fastest TLE")
    )
    assert [cell.strip() for cell in slowest.split("│")[1:4]] == ["2.60", "1.92", "2.00"]
    assert limit.split("│")[1].strip() == "5.00"
    assert [cell.strip() for cell in fastest.split("│")[1:4]] == ["≥ 9.00", "≥ 1.80", "1.50"]
    assert "time_limit_s = 5.5, reference_cpu_s = 0.31" in said


def test_without_write_nothing_is_written(calibrate) -> None:
    status, said, changed = calibrate(slow_s=9.0)
    assert (status, changed, "is written" in said) == (0, [], False)


def test_with_only_nothing_is_written(calibrate) -> None:
    status, said, changed = calibrate("--write", "--only", "textbook.py", slow_s=9.0)
    assert (status, changed, SLOW in said) == (0, [], False)


def test_where_no_limit_fits_nothing_is_written(calibrate) -> None:
    status, said, changed = calibrate("--write", slow_s=6.0)
    assert (status, changed) == (1, [])
    assert "no limit keeps both margins" in said
