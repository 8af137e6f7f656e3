"""The aggregation of results: groups, scores, the first failure, and the JUnit report of it all."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from judge.problem.cases import Case
from judge.problem.declaration import load
from judge.problem.verdict import Verdict
from judge.reports.junit import to_junit
from judge.results import CaseResult, Judging, first_failure, group_results, not_run

PROBLEM = load()
AC, WA, TLE, JE, CE = Verdict.AC, Verdict.WA, Verdict.TLE, Verdict.JE, Verdict.CE


def case(name: str) -> Case:
    return Case(f"secret/{name}", name.partition("/")[0], Path(f"{name}.in"), Path(f"{name}.ans"))


def result(name: str, verdict: Verdict | None, cpu_s: float = 0.5, message: str = "") -> CaseResult:
    return CaseResult(case(name), verdict, cpu_s, cpu_s + 0.25, 30.5, message)


RESULTS = [
    result("static/1", AC),
    result("static/2", AC, 1.5),
    result("small/1", AC),
    result("small/2", TLE, 9.0, "9.00 s of CPU time\nand more"),
    not_run(case("small/3"), "an earlier case of its group failed"),
    result("large/1", JE, 0.0, "the keeper was lost"),
    replace(result("zoo/1", WA, 0.125, "<no>"), retried=True, first_verdict=TLE),
    replace(result("zoo/2", AC, 0.125), retried=True),
]
CASES = [result.case for result in RESULTS]


def judging(results: list[CaseResult], verdict: Verdict = TLE, message: str = "") -> Judging:
    groups = group_results(PROBLEM, CASES, results)
    return Judging("a.py", "Python 3", verdict, 15, 100, True, 5.5, 5.0, 512, None, groups, message)


def test_a_group_scores_if_all_of_its_cases_ran_and_are_accepted() -> None:
    points = {group.name: group.points for group in PROBLEM.groups}
    groups = {group.name: group for group in group_results(PROBLEM, CASES, RESULTS)}
    assert list(groups) == ["static", "small", "large", "zoo"]
    assert [(g.verdict, g.score, g.max_score, g.whole) for g in groups.values()] == [
        (AC, points["static"], points["static"], True),
        (TLE, 0, points["small"], True),
        (JE, 0, points["large"], True),
        (WA, 0, 0, True),
    ]
    assert groups["small"].cases == tuple(RESULTS[2:5])


def test_a_part_of_a_group_does_not_score() -> None:
    (group,) = group_results(PROBLEM, CASES, RESULTS[:1])
    assert (group.verdict, group.score, group.whole) == (AC, 0, False)
    (left_out,) = group_results(PROBLEM, CASES[:1], [not_run(CASES[0], "because")])
    assert (left_out.score, left_out.slowest) == (0, None)
    assert left_out.cases[0].message == "not run: because"


def test_first_failure_changed_verdicts_and_slowest_cases() -> None:
    whole = judging(RESULTS)
    assert whole.cases == tuple(RESULTS)
    assert whole.first_failure == RESULTS[3]
    assert whole.changed == (RESULTS[6],)
    assert [group.slowest for group in whole.groups] == [RESULTS[n] for n in (1, 3, 5, 6)]
    assert judging(RESULTS[:2]).first_failure is None


@pytest.mark.parametrize(
    ("verdicts", "first"),
    [([], AC), ([None, AC], AC), ([AC, None, WA, TLE], WA), ([TLE, WA], TLE)],
)
def test_the_first_failure_decides(verdicts: list[Verdict | None], first: Verdict) -> None:
    assert first_failure(verdicts) is first


PROPERTIES = """\
    <properties>
      <property name="verdict" value="{}" />
      <property name="score" value="15" />
      <property name="max_score" value="100" />
      <property name="language" value="Python 3" />
      <property name="time_limit_s" value="5.5" />
      <property name="memory_limit_mib" value="512" />
    </properties>
"""
TOLD = PROPERTIES.format("TLE")
JUNIT = f"""\
<?xml version='1.0' encoding='utf-8'?>
<testsuites name="a.py" tests="8" failures="2" errors="1" skipped="1" time="13.5000">
  <testsuite name="static" time="2.5000" failures="0" errors="0" skipped="0" tests="2">
{TOLD}\
    <testcase classname="static" name="secret/static/1" time="0.7500">
      <system-out>0.5 s CPU, 0.75 s elapsed, 30.5 MiB</system-out>
    </testcase>
    <testcase classname="static" name="secret/static/2" time="1.7500">
      <system-out>1.5 s CPU, 1.75 s elapsed, 30.5 MiB</system-out>
    </testcase>
  </testsuite>
  <testsuite name="small" time="10.0000" failures="1" errors="0" skipped="1" tests="3">
{TOLD}\
    <testcase classname="small" name="secret/small/1" time="0.7500">
      <system-out>0.5 s CPU, 0.75 s elapsed, 30.5 MiB</system-out>
    </testcase>
    <testcase classname="small" name="secret/small/2" time="9.2500">
      <failure type="TLE" message="9.00 s of CPU time">9.00 s of CPU time
and more</failure>
      <system-out>9.0 s CPU, 9.25 s elapsed, 30.5 MiB</system-out>
    </testcase>
    <testcase classname="small" name="secret/small/3" time="0.0000">
      <skipped message="not run: an earlier case of its group failed" />
    </testcase>
  </testsuite>
  <testsuite name="large" time="0.2500" failures="0" errors="1" skipped="0" tests="1">
{TOLD}\
    <testcase classname="large" name="secret/large/1" time="0.2500">
      <error type="JE" message="the keeper was lost">the keeper was lost</error>
      <system-out>0.0 s CPU, 0.25 s elapsed, 30.5 MiB</system-out>
    </testcase>
  </testsuite>
  <testsuite name="zoo" time="0.7500" failures="1" errors="0" skipped="0" tests="2">
{TOLD}\
    <testcase classname="zoo" name="secret/zoo/1" time="0.3750">
      <failure type="WA" message="&lt;no&gt;">&lt;no&gt;</failure>
      <system-out>0.125 s CPU, 0.375 s elapsed, 30.5 MiB, repeated alone, TLE at first</system-out>
    </testcase>
    <testcase classname="zoo" name="secret/zoo/2" time="0.3750">
      <system-out>0.125 s CPU, 0.375 s elapsed, 30.5 MiB, repeated alone</system-out>
    </testcase>
  </testsuite>
</testsuites>
"""
JUNIT_CE = f"""\
<?xml version='1.0' encoding='utf-8'?>
<testsuites name="a.py" tests="2" failures="1" errors="0" skipped="1" time="0.0000">
  <testsuite name="compile" time="0.0000" failures="1" errors="0" skipped="0" tests="1">
{PROPERTIES.format("CE")}\
    <testcase classname="compile" name="compile" time="0">
      <failure type="CE" message="line 1">line 1
line 2</failure>
    </testcase>
  </testsuite>
  <testsuite name="static" time="0.0000" failures="0" errors="0" skipped="1" tests="1">
{PROPERTIES.format("CE")}\
    <testcase classname="static" name="secret/static/1" time="0.0000">
      <skipped message="not run: does not compile" />
    </testcase>
  </testsuite>
</testsuites>
"""


def test_the_whole_junit_report() -> None:
    assert to_junit(judging(RESULTS)).decode() == JUNIT


def test_the_junit_report_of_a_compile_error() -> None:
    left_out = [not_run(CASES[0], "does not compile")]
    assert to_junit(judging(left_out, CE, "line 1\nline 2")).decode() == JUNIT_CE
