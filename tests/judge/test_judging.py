"""Whole judgings, made in this process."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Callable
from concurrent.futures import Executor, Future
from pathlib import Path
from typing import Any

import pytest

from judge.judging import Events, Options, judge
from judge.languages.submission import Program, Submission, read_submission
from judge.languages.table import by_name
from judge.problem.cases import Case
from judge.problem.order import save_order
from judge.problem.verdict import Verdict
from judge.results import CaseResult, Judging, Scale
from judge.run import run_case
from judge.sandbox.facts import RunLimits
from judge.sandbox.keeper.cgroup import Cgroups
from judge.sandbox.sandbox import Command, Sandbox

from .conftest import QUIET

LIMITS = RunLimits(time_limit_s=5.0, memory_mib=100, output_mib=1)
NOBODY = Submission("nobody's", by_name("python"), b"")
ECHO = "import sys\nsys.stdout.write(sys.stdin.read())\n"
Source = Callable[[str, str], Path]


def judged(path: Path, data: Path, **options: Any) -> Judging:
    executor = options.pop("executor", None)
    events = options.pop("events", None)
    # The tests' own programs are trusted, even where no wall works.
    settings = Options(data=data, no_wall=True, **({"time_limit_s": 5.0} | options))
    return judge(read_submission(path), QUIET, settings, executor=executor, events=events)


def test_points_and_order(source: Source, data: Path) -> None:
    heard: list[CaseResult] = []
    outcome = judged(source("echo.py", ECHO), data, jobs=2, events=Events(result=heard.append))
    assert outcome.verdict is Verdict.AC
    assert (outcome.score, outcome.max_score, outcome.partial) == (30, 100, True)
    assert [(g.name, g.score, g.max_score) for g in outcome.groups] == [
        ("sample", 0, 0),
        ("static", 15, 15),
        ("small", 15, 15),
    ]
    assert heard == list(outcome.cases)
    assert all(0 < r.cpu_s < 5 and 0 < r.elapsed_s < 10 for r in heard)
    # Samples alone may miss what such a short run holds.
    least_mib = 1 if Cgroups().places else 0
    assert all(least_mib <= r.memory_mib < 60 for r in heard)


def test_one_wrong_case_loses_its_group_only(source: Source, data: Path) -> None:
    code = "s = open(0).read().split()\ns[2:] = s[2:] and ['NO']\nprint(*s)\n"
    outcome = judged(source("wrong.py", code), data)
    assert outcome.verdict is Verdict.WA
    assert [(g.verdict, g.score) for g in outcome.groups] == [
        (Verdict.AC, 0),
        (Verdict.AC, 15),
        (Verdict.WA, 0),
    ]
    failure = outcome.first_failure
    assert failure is not None
    assert failure.case.name == "secret/small/02"
    assert failure.message == "scenario 3: expected YES, found NO (line 1, column 7)"


def test_the_first_failure_in_order_is_the_verdict(source: Source, data: Path) -> None:
    code = "s = open(0).read()\nif len(s) < 9: raise SystemExit(len(s))\nprint(1)\n"
    outcome = judged(source("both.py", code), data, jobs=2, stop_on_first=False)
    assert [r.verdict for r in outcome.cases] == ["RTE", "RTE", "RTE", "WA"]
    assert outcome.verdict is Verdict.RTE


def test_a_part_of_a_group_scores_nothing(source: Source, data: Path) -> None:
    outcome = judged(source("echo.py", ECHO), data, globs=("*/01",))
    assert outcome.partial
    assert (outcome.verdict, outcome.score) == (Verdict.AC, 15)
    assert [g.whole for g in outcome.groups] == [True, True, False]


@pytest.mark.parametrize("jobs", [1, 3])
def test_stop_on_first(source: Source, data: Path, jobs: int) -> None:
    code = "s = open(0).read()\nprint('?' if s == 'YES\\nYES\\n' else s)\n"
    outcome = judged(source("wrong.py", code), data, jobs=jobs)
    assert [r.verdict for r in outcome.cases] == ["AC", "AC", "WA", None]
    assert outcome.cases[3].message == "not run: an earlier case of its group failed"
    assert outcome.score == 15


@pytest.mark.parametrize("jobs", [1, 3])
def test_every_case_on_request_and_in_the_order_of_judging(
    source: Source, data: Path, jobs: int
) -> None:
    save_order(data, ["secret/small/02"])
    code = "s = open(0).read()\nprint('?' if s == 'YES\\nYES\\n' else s)\n"
    outcome = judged(source("wrong.py", code), data, stop_on_first=False, jobs=jobs)
    names = [result.case.name for result in outcome.cases]
    assert names[2:] == ["secret/small/02", "secret/small/01"]
    assert [r.verdict for r in outcome.cases] == ["AC", "AC", "AC", "WA"]


def test_a_compile_error_is_a_verdict(source: Source, data: Path) -> None:
    outcome = judged(source("broken.py", "def f(:\n"), data)
    assert outcome.verdict is Verdict.CE
    assert outcome.score == 0
    assert "SyntaxError" in outcome.message
    assert 'File "broken.py", line 1' in outcome.message
    assert {g.verdict for g in outcome.groups} == {Verdict.CE}
    assert {r.verdict for r in outcome.cases} == {None}


def test_a_source_over_the_limit_is_a_compile_error(source: Source, data: Path) -> None:
    text = ECHO + "#" * (QUIET.limits.code_kib << 10)
    assert "limit 256 KiB" in judged(source("long.py", text), data).message


@pytest.mark.slow  # the Java compiler; its other fast test has a package
def test_a_java_class_may_have_any_name(source: Source, data: Path) -> None:
    if shutil.which("javac") is None:
        pytest.skip("javac is not installed")
    code = (
        "class Helper { static int x; }\n"
        "public class Robot {\n"
        "  public static void main(String[] a) throws Exception {\n"
        "    System.in.transferTo(System.out);\n"
        "    System.out.flush();\n"
        "  }\n"
        "}\n"
    )
    assert judged(source("any.java", code), data).verdict is Verdict.AC


def test_the_declared_limit_is_scaled_and_a_given_one_is_not(
    source: Source, data: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = source("echo.py", ECHO)
    monkeypatch.setattr("judge.judging.kept_scale", lambda _problem: Scale(1.5, "kept"))
    scaled = judged(path, data, time_limit_s=None)
    assert (scaled.time_limit_s, scaled.scale) == (
        1.5 * QUIET.limits.time_limit_s,
        Scale(1.5, "kept"),
    )
    asked = judged(path, data, time_limit_s=2.5)
    assert (asked.time_limit_s, asked.scale) == (2.5, None)


class Overloaded(Executor):
    """The first run of each case uses more CPU time than a second one would."""

    def __init__(self, cpu_s: float) -> None:
        self.runs = 0
        self.cpu_s = cpu_s
        self.seen: set[str] = set()

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        result = fn(*args, **kwargs)
        if isinstance(result, CaseResult):
            self.runs += 1
            if result.case.name not in self.seen:
                self.seen.add(result.case.name)
                result = CaseResult(result.case, Verdict.TLE, self.cpu_s, 9.0, 1.0, "slow")
        future.set_result(result)
        return future


@pytest.mark.parametrize("cpu_s", [5.01, LIMITS.kill_cpu_s, 9.0])
@pytest.mark.parametrize("jobs", [1, 2])
def test_one_try_decides(source: Source, data: Path, cpu_s: float, jobs: int) -> None:
    """A program that is slow at random gets no other try, however little it was over the limit."""
    executor = Overloaded(cpu_s)
    path = source("echo.py", ECHO)
    outcome = judged(path, data, jobs=jobs, executor=executor, stop_on_first=False)
    assert executor.runs == 4
    assert {r.verdict for r in outcome.cases} == {Verdict.TLE}
    assert {r.retried for r in outcome.cases} == {False}


class Broken(Executor):
    """An executor whose workers die."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        future.set_exception(RuntimeError("worker died"))
        return future


def test_a_broken_worker_loses_no_result(source: Source, data: Path) -> None:
    assert judged(source("echo.py", ECHO), data, jobs=2, executor=Broken()).verdict is Verdict.AC


def test_a_lost_keeper_is_a_judge_error_never_a_wrong_verdict(data: Path, sandbox: Sandbox) -> None:
    kill_parent = "import os\nos.kill(os.getppid(), 9)\nwhile True: pass\n"
    case = Case("sample/01", "sample", data / "sample/01.in", data / "sample/01.ans")
    result = run_case(
        sandbox,
        Program(NOBODY, Command((sys.executable, "-I", "-S", "-c", kill_parent))),
        RunLimits(time_limit_s=2, memory_mib=100, output_mib=1),
        case,
    )
    assert result.verdict is Verdict.JE
    assert "keeper" in result.message
