"""problem.xml, which describes a Polygon package to its readers."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from export.formats.layout import runnable
from export.package import Package
from export.targets.polygon import generator
from export.targets.polygon.programs import CHECKER_TESTS, CPP, LANGUAGES, tag
from judge.problem.cases import Case

MS_PER_S = 1000
MIB = 1 << 20
# As Polygon names them. %d is the number of a test, from 1.
TEST = "tests/%02d"
CHECKER_TEST = "files/tests/checker-tests/%02d"
VALIDATOR_TEST = "files/tests/validator-tests/%02d"
ANSWER, OUTPUT = ".a", ".o"
GENERATOR = f"files/{generator.NAME}.py"
VALIDATOR, CHECKER, CHECKER_COPY = "files/validator.cpp", "files/check.cpp", "check.cpp"
LATEX = "statements/english/problem.tex"
SOLUTION = "solutions/{}"

Tests = Iterable[dict[str, str]]


def descriptor(package: Package) -> bytes:
    """Return problem.xml. The first test of a group has all its points; the others have 0."""
    problem = package.problem
    root = Element("problem", {"revision": "1", "short-name": problem.short_name})
    names = SubElement(root, "names")
    SubElement(names, "name", language="english", value=problem.name)
    statements = SubElement(root, "statements")
    english = {"language": "english", "mathjax": "true", "charset": "UTF-8"}
    SubElement(statements, "statement", english, path=LATEX, type="application/x-tex")
    # The PDF has its usual place, where CMS looks, but no entry: rbx 2.3 fails at such an entry.
    _judging(root, package)
    executables = SubElement(SubElement(root, "files"), "executables")
    for path, kind in ((VALIDATOR, CPP), (CHECKER, CPP), (GENERATOR, generator.LANGUAGE)):
        SubElement(SubElement(executables, "executable"), "source", path=path, type=kind)
    _assets(root, package)
    properties = SubElement(root, "properties")
    SubElement(properties, "property", name="tests-wellformed", value="true")
    indent(root)
    return bytes(tostring(root, encoding="utf-8", xml_declaration=True)) + b"\n"


def _judging(root: Element, package: Package) -> None:
    limits = package.problem.limits
    judging = SubElement(root, "judging", {"input-file": "", "output-file": "", "run-count": "1"})
    generated = generator.recipes(package)
    tests = [
        {
            **_method(case, generated),
            "group": group.name,
            "points": f"{group.declared.points if number == 0 else 0:.1f}",
            **({"sample": "true"} if case in package.samples else {}),
        }
        for group in package.groups
        for number, case in enumerate(group.cases)
    ]
    testset = SubElement(judging, "testset", name="tests")
    SubElement(testset, "time-limit").text = str(round(limits.time_limit_s * MS_PER_S))
    SubElement(testset, "memory-limit").text = str(limits.memory_mib * MIB)
    _tests(testset, tests, {"input": TEST, "answer": TEST + ANSWER})
    groups = SubElement(testset, "groups")
    for group in package.groups:
        SubElement(
            groups,
            "group",
            {
                "name": group.name,
                "points": f"{group.declared.points:.1f}",
                "points-policy": "complete-group",
                "feedback-policy": "complete" if group.name == "sample" else "icpc",
            },
        )


def _method(case: Case, generated: Container[str]) -> dict[str, str]:
    """Say how the input of a test comes to Polygon: as text, or by the generator."""
    arguments = generator.arguments(case)
    if arguments in generated:
        return {"method": "generated", "cmd": f"{generator.NAME} {arguments}"}
    return {"method": "manual"}


def _assets(root: Element, package: Package) -> None:
    assets = SubElement(root, "assets")
    checker = SubElement(assets, "checker", type="testlib")
    SubElement(checker, "source", path=CHECKER, type=CPP)
    SubElement(checker, "copy", path=CHECKER_COPY)
    patterns = {
        "input": CHECKER_TEST,
        "output": CHECKER_TEST + OUTPUT,
        "answer": CHECKER_TEST + ANSWER,
    }
    tests: Tests = ({"verdict": test.verdict} for test in CHECKER_TESTS)
    _tests(SubElement(checker, "testset"), tests, patterns)

    validator = SubElement(SubElement(assets, "validators"), "validator")
    SubElement(validator, "source", path=VALIDATOR, type=CPP)
    _tests(SubElement(validator, "testset"), _validator_tests(package), {"input": VALIDATOR_TEST})

    listed = SubElement(assets, "solutions")
    for submission in runnable(package):
        solution = SubElement(listed, "solution", {"tag": tag(submission)})
        kind = LANGUAGES[submission.path.suffix]
        SubElement(solution, "source", path=SOLUTION.format(submission.file), type=kind)


def _validator_tests(package: Package) -> Tests:
    """Yield the samples, which are valid, then the invalid files."""
    for case in package.samples:
        yield {"verdict": "valid", "testset": "tests", "group": case.group}
    for fault in package.invalid_inputs:
        held = {"testset": "tests", "group": fault.group} if fault.group else {}
        yield {"verdict": "invalid", **held}


def _tests(testset: Element, tests: Tests, patterns: Mapping[str, str]) -> None:
    """Describe numbered tests: how many, where their files are, their attributes."""
    count = SubElement(testset, "test-count")
    for kind, pattern in patterns.items():
        SubElement(testset, f"{kind}-path-pattern").text = pattern
    listed = SubElement(testset, "tests")
    for attributes in tests:
        SubElement(listed, "test", attributes)
    count.text = str(len(listed))
