"""The JUnit report: the same verdicts, for tools that show test results.

A group is a test suite and a case a test case. AC passes; JE is an error; every other
verdict is a failure of that type; a case that was not run is skipped. A compile error adds a
failing test case, `compile`, because skipped cases alone would look like a success.
Source: the schema of Jenkins' xUnit plugin (junit-10.xsd), which CI systems share.
"""

from __future__ import annotations

from xml.etree import ElementTree as ET

from judge.problem.verdict import Verdict
from judge.results import CaseResult, Judging


def to_junit(judging: Judging) -> bytes:
    """Return the report as XML in UTF-8."""
    root = ET.Element("testsuites", name=judging.submission)
    if judging.verdict is Verdict.CE:
        suite = _suite(root, "compile", [])
        test = ET.SubElement(suite, "testcase", classname="compile", name="compile", time="0")
        _add(test, "failure", Verdict.CE, judging.message)
    for group in judging.groups:
        suite = _suite(root, group.name, list(group.cases))
        for result in group.cases:
            _case(suite, result)
    for suite in root:
        for kind in ("failure", "error", "skipped"):
            plural = {"failure": "failures", "error": "errors"}.get(kind, kind)
            suite.set(plural, str(len(suite.findall(f"testcase/{kind}"))))
        suite.set("tests", str(len(suite.findall("testcase"))))
    for total in ("tests", "failures", "errors", "skipped"):
        root.set(total, str(sum(int(suite.get(total, "0")) for suite in root)))
    root.set("time", f"{sum(result.elapsed_s for result in judging.cases):.4f}")
    facts = ET.Element("properties")
    for name, value in (
        ("verdict", judging.verdict.value),
        ("score", judging.score),
        ("max_score", judging.max_score),
        ("language", judging.language),
        ("time_limit_s", judging.time_limit_s),
        ("memory_limit_mib", judging.memory_mib),
    ):
        ET.SubElement(facts, "property", name=name, value=str(value))
    for suite in root:  # the format allows properties only in a suite
        suite.insert(0, facts)
    ET.indent(root)
    text: bytes = ET.tostring(root, encoding="utf-8", xml_declaration=True)
    return text + b"\n"


def _suite(root: ET.Element, name: str, results: list[CaseResult]) -> ET.Element:
    elapsed_s = sum(result.elapsed_s for result in results)
    return ET.SubElement(root, "testsuite", name=name, time=f"{elapsed_s:.4f}")


def _case(suite: ET.Element, result: CaseResult) -> None:
    test = ET.SubElement(
        suite,
        "testcase",
        classname=result.case.group,
        name=result.case.name,
        time=f"{result.elapsed_s:.4f}",
    )
    if result.verdict is None:
        ET.SubElement(test, "skipped", message=result.message)
        return
    if result.verdict is Verdict.JE:
        _add(test, "error", result.verdict, result.message)
    elif result.verdict is not Verdict.AC:
        _add(test, "failure", result.verdict, result.message)
    facts = f"{result.cpu_s} s CPU, {result.elapsed_s} s elapsed, {result.memory_mib} MiB"
    if result.retried:
        first = f", {result.first_verdict} at first" if result.first_verdict else ""
        facts += f", repeated{first}"
    ET.SubElement(test, "system-out").text = facts
    if result.stderr:
        ET.SubElement(test, "system-err").text = result.stderr


def _add(test: ET.Element, kind: str, verdict: Verdict, message: str) -> None:
    element = ET.SubElement(test, kind, type=verdict.value, message=message.partition("\n")[0])
    element.text = message
