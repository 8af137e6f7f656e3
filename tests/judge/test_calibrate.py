"""Margins of the time limit, from made-up times."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from judge.calibrate import Time, main, margins, written
from judge.judging import JudgeError
from judge.spec import PROBLEM_FILE, load
from judge.verdict import Verdict

PROBLEM = load()
ASKED = PROBLEM.limits.time_multipliers


def time(expected: Verdict, cpu_s: float) -> Time:
    return Time(f"{expected}/{cpu_s}", "large", expected, "secret/large/01", cpu_s, False)


@pytest.mark.parametrize(
    ("slowest_s", "fastest_s", "declared_s", "proposal_s"),
    [
        (2.0, 9.0, 5.0, 5.0),  # it fits: nothing is changed
        (2.0, 9.0, 7.0, 4.0),  # too long for the slow one
        (2.6, 9.0, 5.0, 5.5),  # too short for the accepted one; the next half second
        (2.5, 7.5, 5.0, 5.0),  # both margins exactly
        (3.1, 9.0, 5.0, None),  # they are too near each other
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


def test_without_slow_ones_any_limit_is_short_enough() -> None:
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


def test_nothing_to_time(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--only", "no such submission"]) == 2
    assert "expected part of a name" in capsys.readouterr().err
