"""One row for every way from facts to a verdict."""

from __future__ import annotations

import pytest

from judge.compare import Mismatch
from judge.decide import decide
from judge.languages.submission import Program, Submission
from judge.languages.table import by_name
from judge.problem.verdict import Verdict
from judge.sandbox.facts import Facts, RunLimits, Stop
from judge.sandbox.sandbox import Command

LIMITS = RunLimits(time_limit_s=2.0, memory_mib=100, output_mib=1)
FINE = Facts(
    exit_status=0,
    signal=None,
    cpu_s=1.0,
    elapsed_s=1.1,
    memory_mib=50,
    output_bytes=9,
    stopped=None,
)
KILLED = {"exit_status": None, "signal": 9}
WRONG = Mismatch(scenario=3, line=3, column=1, expected="NO", found="YES")

JAVA = b'Exception in thread "main" x\nException in thread "b" y\n\tat Main.main\n'

ROWS = [
    # changed facts, comparison, verdict, words of the message
    ({}, None, Verdict.AC, ""),
    ({}, WRONG, Verdict.WA, "scenario 3: expected NO"),
    ({"exit_status": 3}, None, Verdict.RTE, "exit status 3"),
    ({"exit_status": 3}, WRONG, Verdict.RTE, "exit status 3"),
    ({"exit_status": -3}, None, Verdict.RTE, "exit status -3"),
    ({"exit_status": 139}, None, Verdict.RTE, "exit status 139 (its own, or ended by SIGSEGV"),
    ({"exit_status": 128}, None, Verdict.RTE, "exit status 128"),
    ({"exit_status": None, "signal": 11}, None, Verdict.RTE, "SIGSEGV"),
    ({"exit_status": None, "signal": 40}, None, Verdict.RTE, "signal 40"),
    ({"cpu_s": 2.0}, None, Verdict.AC, ""),
    ({"cpu_s": 2.01}, None, Verdict.TLE, "2.01 s of CPU time, limit 2.00 s"),
    ({"cpu_s": 2.01}, WRONG, Verdict.TLE, "CPU time"),
    ({"cpu_s": 2.01, "exit_status": 1}, None, Verdict.TLE, "CPU time"),
    ({**KILLED, "stopped": Stop.CPU, "cpu_s": 2.3}, WRONG, Verdict.TLE, "CPU time"),
    ({**KILLED, "stopped": Stop.ELAPSED, "elapsed_s": 7.0}, WRONG, Verdict.TLE, "slept or waited"),
    ({"elapsed_s": 6.9}, None, Verdict.AC, ""),
    ({"memory_mib": 100.0}, None, Verdict.AC, ""),
    ({"memory_mib": 100.1}, None, Verdict.MLE, "limit 100 MiB"),
    ({**KILLED, "stopped": Stop.MEMORY, "memory_mib": 120}, WRONG, Verdict.MLE, "120 MiB"),
    ({"memory_mib": 120, "exit_status": 1}, None, Verdict.MLE, "120 MiB"),
    ({"output_bytes": 1 << 20}, None, Verdict.AC, ""),
    ({"output_bytes": (1 << 20) + 1}, WRONG, Verdict.OLE, "more than 1 MiB of output"),
    ({**KILLED, "stopped": Stop.OUTPUT}, WRONG, Verdict.OLE, "output"),
    ({**KILLED, "stopped": Stop.PROCESSES}, WRONG, Verdict.RTE, "too many processes"),
]


@pytest.mark.parametrize(("change", "mismatch", "verdict", "words"), ROWS)
def test_facts_to_verdict(
    change: dict[str, object], mismatch: Mismatch | None, verdict: Verdict, words: str
) -> None:
    judgement = decide(FINE._replace(**change), LIMITS, mismatch)
    assert judgement.verdict is verdict
    assert words in judgement.message
    assert (judgement.message == "") == (verdict is Verdict.AC)


def test_every_reason_to_stop_has_a_row() -> None:
    assert {row[0].get("stopped") for row in ROWS} == {None, *Stop}


@pytest.mark.parametrize(
    ("language", "stderr", "reason"),
    [
        ("python", b"Traceback\n  File\nKeyError: 7\n", "KeyError: 7"),
        ("python", JAVA, "\tat Main.main"),
        ("java", JAVA, 'Exception in thread "main" x'),
        ("java", b"Killed\n", "Killed"),
        ("c++", b"", ""),
        ("c++", b"\x1b[2J\x1b[H AC", r"\x1b[2J\x1b[H AC"),  # it cannot move the cursor
    ],
)
def test_the_reason_of_a_crash(language: str, stderr: bytes, reason: str) -> None:
    program = Program(Submission("x", by_name(language), b""), Command(("/x",)))
    found = program.reason(stderr)
    assert found == reason.expandtabs(4)
    crashed = FINE._replace(exit_status=1)
    message = f"exit status 1: {found}" if reason else "exit status 1"
    assert decide(crashed, LIMITS, None, found).message == message
