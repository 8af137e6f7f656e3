"""A whole class as a user judges it: reports, duplicates, feedback, going on after a crash."""

from __future__ import annotations

import csv
import json
import os
import signal
import subprocess
import sys
import time
import uuid
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import replace
from pathlib import Path

import msgspec
import pytest

from judge.batch.outcome import GroupOutcome, Outcome
from judge.batch.reports import plain
from judge.batch.session import Places, judge_class
from judge.batch.tasks import Task, judge_task
from judge.judging import JudgeError, Options
from judge.kit.console import PlainConsole
from judge.kit.paths import ROOT
from judge.languages.submission import from_source
from judge.problem.declaration import Feedback, load
from judge.problem.verdict import Verdict
from judge.sandbox.probe import NoWallError
from judge.sandbox.sandbox import Sandbox

from ..conftest import WRONG, write_case

Checker = Callable[..., "subprocess.CompletedProcess[str]"]
ECHO = "import sys\nsys.stdout.write(sys.stdin.read())\n"


def new(text: str) -> str:
    """Return a program that no earlier test run has judged."""
    return f"# {uuid.uuid4()}\n{text}"


@pytest.fixture
def hand_in(tmp_path: Path) -> Callable[[str, str], Path]:
    """Write a file of the class, and return the directory of the class."""

    def write(name: str, text: str) -> Path:
        path = tmp_path / "class" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return tmp_path / "class"

    return write


def lines_of(path: Path) -> list[dict[str, object]]:
    """Return the rows of a file of JSON lines; a line that is not whole is an error."""
    text = path.read_text()
    assert not text or text.endswith("\n")
    return [json.loads(line) for line in text.splitlines()]


def test_the_reports_of_a_class(
    checker: Checker, hand_in: Callable[[str, str], Path], data: Path, tmp_path: Path
) -> None:
    right = new(ECHO)
    hand_in("ann.py", right)
    hand_in("bob.py", right)
    hand_in("=carl+1.py", new(WRONG))
    place = hand_in("dora.cpp/none.pdf", "\0")
    paths = [tmp_path / name for name in ("s.csv", "r.html", "r.jsonl")]
    options = ("--csv", paths[0], "--html", paths[1], "--json", paths[2])
    done = checker(place, "--data", data, "--time-limit", 5, *options)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "4 hand-ins: 2 programs judged" in done.stdout

    table = list(csv.DictReader(paths[0].read_text(encoding="utf-8-sig").splitlines()))
    assert [(row["student"], row["verdict"], row["score"]) for row in table] == [
        ("'=carl+1", "WA", "0"),
        ("ann", "AC", "30"),
        ("bob", "AC", "30"),
        ("dora.cpp", "", ""),
    ]
    assert (table[0]["static"], table[1]["static"], table[1]["large"]) == ("0", "15", "")
    assert "answers" in table[0]["diagnosis"]
    assert table[0]["failure"].startswith("secret/static/01: scenario 1: expected NO")
    assert (table[1]["note"], table[2]["note"]) == ("identical to bob.py", "identical to ann.py")
    assert "binary data" in table[3]["reason"]

    rows = {row["student"]: row for row in lines_of(paths[2])}
    assert len(rows) == 4
    assert rows["ann"]["groups"] == rows["bob"]["groups"]
    assert rows["=carl+1"]["lessons"] == ["answers"]
    assert (rows["dora.cpp"]["verdict"], rows["ann"]["kept"]) == (None, False)

    page = paths[1].read_text()
    assert "=carl+1" in page
    assert "identical to bob.py" in page
    assert "<script" not in page

    again = checker(place, "--data", data, "--time-limit", 5, "--json", paths[2])
    assert "4 hand-ins: 0 programs judged" in again.stdout
    assert {row["kept"] for row in lines_of(paths[2]) if row["verdict"]} == {True}


@contextmanager
def threads() -> Iterator[Executor]:
    with ThreadPoolExecutor(2) as executor:
        yield executor


class Judge:
    """Judges a directory in this process with pretended outcomes, and counts them."""

    def __init__(self, data: Path) -> None:
        self.runs: list[bytes] = []
        self.options = Options(data=data, jobs=2, time_limit_s=5.0, no_wall=True)
        self.problem = load()
        self.verdict = Verdict.AC
        self.hidden: tuple[Path, ...] = ()

    def __call__(self, place: Path, places: Places | None = None) -> list[Verdict | None]:
        self.runs = []
        rows = judge_class(
            place,
            self.problem,
            self.options,
            places or Places(),
            None,
            PlainConsole(),
            executors=threads,
            work=self._pretend,
        )
        return [None if row.outcome is None else row.outcome.verdict for row in rows]

    def _pretend(self, task: Task) -> Outcome:
        self.runs.append(task.submission.source)
        self.hidden = task.options.hidden
        groups = [GroupOutcome("static", self.verdict, 15, 15)]
        return Outcome(self.verdict, 15, 100, groups, 0.1, lessons=["answers"])


def test_each_program_is_judged_once(hand_in: Callable[[str, str], Path], data: Path) -> None:
    judge, right, other = Judge(data), new(ECHO), new(ECHO)
    for number in range(5):
        hand_in(f"{number}.py", right)
    hand_in("other.py", other)
    place = hand_in("as_text", right)  # it has no suffix, and is Python by its text
    assert judge(place) == [Verdict.AC] * 7
    assert judge.hidden == (place,), "no program may see the others"
    assert sorted(judge.runs) == sorted([right.encode(), other.encode()])
    (place / "as_text").rename(place / "in_another_language.cpp")
    judge(place)
    assert judge.runs == [right.encode()]


def test_an_outcome_is_kept_for_what_it_depends_on(
    hand_in: Callable[[str, str], Path], data: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("judge.batch.session._scale", lambda *_: None)  # whether a wall works here
    judge = Judge(data)
    place = hand_in("ann.py", new(ECHO))
    assert (judge(place), len(judge.runs)) == ([Verdict.AC], 1)
    assert (judge(place), len(judge.runs)) == ([Verdict.AC], 0)
    options = judge.options
    for changed in (
        msgspec.structs.replace(judge.problem, feedback=Feedback("verdict", False)),
        msgspec.structs.replace(
            judge.problem,
            limits=msgspec.structs.replace(judge.problem.limits, memory_mib=511),
        ),
    ):
        judge.problem, before = changed, judge.problem
        judge(place)
        assert len(judge.runs) == 1, "another declaration"
        judge.problem = before
    for changed_options in (
        replace(options, time_limit_s=6.0),
        replace(options, stop_on_first=False),
        replace(options, groups=("small",)),
        replace(options, no_wall=False),
    ):
        judge.options = changed_options
        judge(place)
        assert len(judge.runs) == 1, changed_options
    judge.options = options
    judge(place)
    assert len(judge.runs) == 0
    write_case(data, "secret/small/01", "YES\nYES\n", "YES\nNO\n")
    judge(place)
    assert len(judge.runs) == 1, "an answer was changed"
    with monkeypatch.context() as changed_code:
        changed_code.setattr("judge.batch.kept.judge_digest", lambda _: "other code")
        judge(place)
        assert len(judge.runs) == 1, "the judge was changed"
    (place / "ann.py").write_text(new(ECHO))
    judge(place)
    assert len(judge.runs) == 1, "the program was changed"


def test_a_judge_error_is_not_kept(hand_in: Callable[[str, str], Path], data: Path) -> None:
    judge = Judge(data)
    place = hand_in("ann.py", new(ECHO))
    judge.verdict = Verdict.JE
    assert judge(place) == [Verdict.JE]
    judge.verdict = Verdict.WA
    assert judge(place) == [Verdict.WA]
    assert len(judge.runs) == 1


def test_data_that_changes_meanwhile_keeps_nothing(
    hand_in: Callable[[str, str], Path], data: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    judge = Judge(data)
    place = hand_in("ann.py", new(ECHO))
    pretend = judge._pretend
    before = (data / "secret/small/02.in").read_text()

    def change(task: Task) -> Outcome:
        write_case(data, "secret/small/02", "NO\n", "YES\n")
        return pretend(task)

    monkeypatch.setattr(judge, "_pretend", change)
    judge(place)
    monkeypatch.setattr(judge, "_pretend", pretend)
    write_case(data, "secret/small/02", before, before)
    judge(place)
    assert len(judge.runs) == 1


def test_without_a_wall_nothing_is_judged(
    hand_in: Callable[[str, str], Path], data: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def none(*_: object, **__: object) -> Sandbox:
        raise NoWallError("it is an old kernel")

    monkeypatch.setattr("judge.batch.session.walled_sandbox", none)
    judge = Judge(data)
    with pytest.raises(JudgeError, match=r"an old kernel.*--no-wall"):
        judge(hand_in("ann.py", new(ECHO)))
    assert judge.runs == []


def test_a_missing_compiler_is_a_judge_error_of_these_rows(
    checker: Checker, hand_in: Callable[[str, str], Path], data: Path, tmp_path: Path
) -> None:
    hand_in("ann.py", new(ECHO))
    place = hand_in("bob.cpp", f"// {uuid.uuid4()}\nint main() {{}}\n")
    env = {**os.environ, "PATH": "/nowhere", "TMPDIR": str(tmp_path / "scratch")}
    report = tmp_path / "r.jsonl"
    options = ("--data", data, "--group", "sample", "--time-limit", 5, "--json", report)
    done = checker(place, *options, env=env)
    assert done.returncode == 2, done.stderr
    rows = {row["student"]: row for row in lines_of(report)}
    assert (rows["ann"]["verdict"], rows["bob"]["verdict"]) == ("AC", "JE")
    assert "'g++' is not installed" in str(rows["bob"]["failure"])


def test_feedback_decides_what_a_class_report_says(data: Path) -> None:
    feedback = Feedback(tell="verdict", name_secret_cases=False)
    problem = msgspec.structs.replace(load(), feedback=feedback)
    options = Options(data=data, time_limit_s=5.0, no_wall=True)
    outcome = judge_task(Task(from_source(WRONG.encode(), "w.py"), problem, options))
    assert (outcome.verdict, outcome.lessons, outcome.like) == (Verdict.WA, [], "")
    assert outcome.failure == "secret/static/#1"


def processes_of(scratch: Path) -> list[str]:
    """Return the processes whose scratch files would be there."""
    found = []
    for path in Path("/proc").glob("[0-9]*/environ"):
        with suppress(OSError):
            if f"TMPDIR={scratch}".encode() in path.read_bytes().split(b"\0"):
                found.append(path.parent.name)
    return found


@pytest.mark.parametrize(
    "signum", [signal.SIGKILL, pytest.param(signal.SIGINT, marks=pytest.mark.slow)]
)
def test_a_judging_that_is_ended_goes_on_where_it_was(
    signum: int, hand_in: Callable[[str, str], Path], data: Path, tmp_path: Path
) -> None:
    for number in range(5):
        place = hand_in(f"{number}.py", new(f"import time\ntime.sleep(0.08)\n{ECHO}"))
    scratch, report = tmp_path / "scratch", tmp_path / "r.jsonl"
    scratch.mkdir()
    options = ["--no-wall", "--data", str(data), "--time-limit", "5", "--jobs", "1"]
    command = [sys.executable, str(ROOT / "checker.py"), str(place), *options]
    command += ["--json", str(report), "--csv", str(tmp_path / "s.csv")]
    env = {**os.environ, "TMPDIR": str(scratch)}
    with subprocess.Popen(
        command, env=env, stdout=-3, stderr=-1, text=True, start_new_session=True
    ) as first:
        give_up = time.monotonic() + 60
        while not report.exists() or report.read_bytes().count(b"\n") < 2:
            assert first.poll() is None
            assert time.monotonic() < give_up
            time.sleep(0.01)
        if signum == signal.SIGINT:
            os.killpg(first.pid, signum)  # as Ctrl-C does
        else:
            first.kill()
        said = first.communicate(timeout=60)[1]
    assert "Traceback" not in said
    assert first.returncode == (130 if signum == signal.SIGINT else -signum)
    give_up = time.monotonic() + 30
    while time.monotonic() < give_up and (processes_of(scratch) or any(scratch.iterdir())):
        time.sleep(0.02)
    assert not processes_of(scratch)
    assert not list(scratch.iterdir())
    done = {row["file"] for row in lines_of(report)}
    assert 2 <= len(done) < 5

    subprocess.run(command, env=env, stdout=-3, timeout=60, check=True)
    rows = lines_of(report)
    assert {row["file"] for row in rows if row["kept"]} >= done
    assert [row["verdict"] for row in rows] == ["AC"] * 5
    assert len((tmp_path / "s.csv").read_text().splitlines()) == 6


def test_usage(checker: Checker, data: Path, hand_in: Callable[[str, str], Path]) -> None:
    place = hand_in("ann.py", ECHO)
    for arguments, words in [
        ((place,), "expected a source file, found a directory; for a whole class"),
        ((place, "--csv", "s.csv", "--explain"), "--explain: expected one source file"),
        ((place, "--csv", "s.csv", "--junit", "j.xml"), "--junit: expected one source file"),
        ((place, "--csv", "s.csv", "--html", "s.csv"), "expected a file of its own"),
        ((place / "ann.py", "--csv", "s.csv"), "--csv: expected a directory or a zip"),
        ((data, "--csv", "no/s.csv"), "no such directory"),
    ]:
        done = checker(*arguments)
        assert (done.returncode, done.stderr.count("\n")) == (2, 1)
        assert words in done.stderr


def test_no_cell_is_a_formula() -> None:
    for cell in ("=1", "+1", "-1", "@x", " =1", "\t=1", "\r\n=1"):
        assert plain(cell).startswith("'")
    assert plain("a=1\n b") == "a=1 b"
