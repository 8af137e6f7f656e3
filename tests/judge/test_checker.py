"""checker.py as a user starts it: messages, exit status, nothing left."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path

import pytest

from judge.kit.paths import ROOT

from .conftest import WRONG

ECHO = "import sys\nsys.stdout.write(sys.stdin.read())\n"
# Wrong in the longest case; in step with the gallery.
CUT = "s = open(0).read()\nt = int(s.split()[0]) if s[0].isdigit() else 1\n"
CUT += "print(s if len(s) < 9 else '\\n'.join(['NO'] * t))\n"
ECHO_CPP = "#include <iostream>\nint main() { std::cout << std::cin.rdbuf(); }\n"
Source = Callable[[str, str], Path]
Checker = Callable[..., "subprocess.CompletedProcess[str]"]


def one_line(done: subprocess.CompletedProcess[str]) -> str:
    """Return the message of a run that could not be judged."""
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.count("\n") == 1
    return done.stderr


def test_accepted(checker: Checker, source: Source, data: Path) -> None:
    done = checker(source("echo.py", ECHO), "--data", data, "--time-limit", 3)
    assert done.returncode == 0, done.stderr
    assert "AC  30 of 100 points" in done.stdout
    assert re.search(
        r"AC +\d\.\d\d s CPU +\d\.\d\d s elapsed +\d+ MiB  secret/small/02", done.stdout
    )
    assert "\x1b" not in done.stdout


@pytest.mark.parametrize(
    "arguments", [(), pytest.param(("-",), marks=pytest.mark.slow), ("--language", "cpp")]
)
def test_source_from_standard_input(
    checker: Checker, data: Path, arguments: tuple[str, ...]
) -> None:
    if shutil.which("g++") is None:
        pytest.skip("g++ is not installed")
    done = checker(*arguments, "--data", data, "--group", "sample", input=ECHO_CPP)
    assert done.returncode == 0, done.stderr
    assert "standard input (C++)" in done.stdout


def test_wrong_answer_says_where(checker: Checker, source: Source, data: Path) -> None:
    done = checker(source("w.py", WRONG), "--data", data)
    assert done.returncode == 1
    assert (
        "first failure: WA on secret/static/01: scenario 1: expected NO, found YES" in done.stdout
    )
    assert "secret/static/01.in" in done.stdout
    assert "see it" not in done.stdout, "its input is none of this problem"


def test_a_fake_verdict_stays_output(checker: Checker, source: Source, data: Path) -> None:
    done = checker(source("f.py", "print('\\x1b[2J AC 100 of 100 points')\n"), "--data", data)
    assert done.returncode == 1
    assert "\x1b" not in done.stdout + done.stderr


def test_json(checker: Checker, source: Source, data: Path, tmp_path: Path) -> None:
    report = tmp_path / "report.json"
    done = checker(source("w.py", CUT), "--data", data, "--json", report, "--stop-on-first")
    assert done.returncode == 1
    table = json.loads(report.read_text())
    assert table["schema_version"] == 4
    assert (table["verdict"], table["score"], table["max_score"]) == ("WA", 15, 100)
    assert table["groups"][2] == {"name": "small", "verdict": "WA", "score": 0, "max_score": 15}
    case = table["cases"][3]
    assert (case["case"], case["group"], case["verdict"]) == ("secret/small/02", "small", "WA")
    assert case["message"].startswith("scenario 2: expected NO, found the end")
    assert {"cpu_s", "wall_s", "memory_mib"} <= set(case)
    mismatch = {"scenario": 2, "line": 2, "column": 1, "expected": "NO", "found": None}
    assert case["mismatch"] == mismatch
    assert table["cases"][0]["mismatch"] is None
    assert sorted(p.name for p in tmp_path.iterdir() if "report" in p.name) == ["report.json"]


def test_junit_says_what_json_says(
    checker: Checker, source: Source, data: Path, tmp_path: Path
) -> None:
    paths = (tmp_path / "report.json", tmp_path / "report.xml")
    options = ("--data", data, "--stop-on-first", "--json", paths[0], "--junit", paths[1])
    assert checker(source("w.py", CUT), *options).returncode == 1
    table, root = json.loads(paths[0].read_text()), ET.parse(paths[1]).getroot()
    tests = {test.get("name"): test for test in root.iter("testcase")}
    for case in table["cases"]:
        failure = tests[case["case"]].find("failure")
        assert (None if failure is None else failure.get("type")) == (
            None if case["verdict"] == "AC" else case["verdict"]
        )
        assert failure is None or failure.get("message") == case["message"]
    counts = [root.get(name) for name in ("tests", "failures", "errors", "skipped")]
    assert counts == ["4", "1", "0", "0"]
    facts = {p.get("name"): p.get("value") for p in root.iter("property")}
    assert (facts["verdict"], facts["score"]) == (table["verdict"], str(table["score"]))


def test_the_junit_report_of_a_compile_error(
    checker: Checker, source: Source, data: Path, tmp_path: Path
) -> None:
    report = tmp_path / "report.xml"
    checker(source("e.py", "def f(:\n"), "--data", data, "--junit", report)
    root = ET.parse(report).getroot()
    assert [f.get("type") for f in root.iter("failure")] == ["CE"]
    assert [root.get(name) for name in ("tests", "failures", "skipped")] == ["5", "1", "4"]


def test_a_file_name_cannot_move_the_cursor(checker: Checker, source: Source, data: Path) -> None:
    strange = source(os.fsdecode(b"\x1b[2J\xff.py"), ECHO)
    done = checker(strange, "--data", data, "--group", "sample")
    assert done.returncode == 0, done.stderr
    missing = checker(f"{strange}x")
    assert (missing.returncode, missing.stderr.count("\n")) == (2, 1)
    assert "\x1b" not in done.stdout + missing.stderr


def test_compile_error(checker: Checker, source: Source, data: Path) -> None:
    if shutil.which("g++") is None:
        pytest.skip("g++ is not installed")
    done = checker(source("e.cpp", "int main() { return x; }\n"), "--data", data)
    assert done.returncode == 1
    assert "does not compile" in done.stdout
    assert "e.cpp:1:21: error" in done.stdout
    assert "submission.cpp" not in done.stdout
    assert "CE  0 of 100 points" in done.stdout


@pytest.mark.parametrize("form", ["crlf", "bom"])
@pytest.mark.parametrize("name", ["echo.py", "echo.cpp"])
def test_a_source_and_an_output_with_the_line_ends_of_windows(
    checker: Checker, tmp_path: Path, data: Path, name: str, form: str
) -> None:
    """Neither matters: compilers take both, and answers are compared word by word."""
    if name.endswith("cpp") and shutil.which("g++") is None:
        pytest.skip("g++ is not installed")
    python = "import sys\nfor line in sys.stdin:\n    print(line.rstrip(), end='\\r\\n')\n"
    text = python if name.endswith("py") else ECHO_CPP
    path = tmp_path / name
    path.write_bytes(
        text.replace("\n", "\r\n").encode() if form == "crlf" else text.encode("utf-8-sig")
    )
    done = checker(path, "--data", data)
    assert done.returncode == 0, done.stdout + done.stderr


def test_what_cannot_be_judged_is_told_in_one_line(
    checker: Checker, source: Source, data: Path, tmp_path: Path
) -> None:
    echo = source("echo.py", ECHO)
    for arguments, words in [
        ((tmp_path / "none.py",), "no such file"),
        ((tmp_path,), "found a directory"),
        ((source("empty.py", ""),), "found nothing in it"),
        ((echo, "--language", "cobol"), "unknown language 'cobol'"),
        ((echo, "--data", tmp_path / "nowhere"), "no such directory"),
        ((echo, "--data", data, "--group", "larg"), "no group 'larg'"),
        ((echo, "--data", data, "--case", "zzz"), "no test case matches"),
        ((echo, "--data", data, "--json", tmp_path / "no" / "x.json"), "no such directory"),
    ]:
        assert words in one_line(checker(*arguments))
    assert "standard input: expected a source text" in one_line(checker())


def test_usage(checker: Checker, source: Source) -> None:
    echo = source("echo.py", ECHO)
    assert "examples:" in checker("--help").stdout
    for arguments in [("--jobs", "0"), ("--jobs", "x"), ("--time-limit", "nan"), ("--what",)]:
        done = checker(echo, *arguments)
        assert done.returncode == 2
        assert "usage:" in done.stderr


def test_started_with_another_python(source: Source, data: Path) -> None:
    python = next((p for p in ("/usr/bin/python3", "/bin/python3") if Path(p).is_file()), None)
    if python is None:
        pytest.skip("the system has no Python of its own")
    if not (ROOT / ".venv/bin/python").exists():
        pytest.skip("the kit has no environment of its own here")
    command = [python, str(ROOT / "checker.py"), str(source("echo.py", ECHO)), "--data", str(data)]
    done = subprocess.run(command, capture_output=True, text=True, cwd="/", timeout=60)
    assert done.returncode == 0, done.stderr


def test_before_set_up(tmp_path: Path) -> None:
    """A copy of the kit without environment, started with a Python without packages."""
    shutil.copy(ROOT / "checker.py", tmp_path)
    shutil.copytree(ROOT / "judge", tmp_path / "judge")
    python = os.path.realpath(sys.executable)
    command = [python, "-S", str(tmp_path / "checker.py"), "x.py"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode == 2
    setup = f"run 'make -C {tmp_path} setup' first"
    assert done.stderr == f"checker.py: the kit is not set up: {setup}\n"


def test_a_broken_declaration(source: Source, tmp_path: Path) -> None:
    shutil.copy(ROOT / "checker.py", tmp_path)
    for part in ("judge", "stress"):
        shutil.copytree(ROOT / part, tmp_path / part)
    text = (ROOT / "problem.toml").read_text()
    (tmp_path / "problem.toml").write_text(text.replace("memory_mib", "memory_mb", 1))
    command = [sys.executable, str(tmp_path / "checker.py"), str(source("echo.py", ECHO))]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode == 2
    assert "unknown key 'memory_mb'; did you mean 'memory_mib'?" in done.stderr
    assert done.stderr.count("\n") == 1


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted(source: Source, data: Path, tmp_path: Path, number: signal.Signals) -> None:
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    endless = source("endless.py", "while True: pass\n")
    command = [sys.executable, str(ROOT / "checker.py"), str(endless), "--data", str(data)]
    with subprocess.Popen(
        [
            *command,
            "--no-wall",
            "--jobs",
            "2",
            "--time-limit",
            "60",
            "--json",
            f"{tmp_path}/report.json",
        ],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "TMPDIR": str(scratch)},
    ) as process:
        give_up = time.monotonic() + 30
        while not list(scratch.glob("*/output-*/stdout")) and time.monotonic() < give_up:
            time.sleep(0.02)  # until the program runs
        process.send_signal(number)
        _, stderr = process.communicate(timeout=30)
    assert process.returncode == 130
    assert stderr == "checker.py: interrupted, nothing is left running\n"
    assert list(scratch.iterdir()) == []
    assert not (tmp_path / "report.json").exists()
    for other in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            assert str(scratch).encode() not in other.read_bytes()
        except OSError:
            continue
