"""Polygon packages: validator and checker against the kit's own, and rbx as a reader."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from xml.etree.ElementTree import Element, parse

import yaml

from export.verify.inputs import spoiled_inputs, valid
from export.verify.job import Job, VerifyError, run_tool
from export.verify.outputs import accepted, random_outputs
from export.verify.testlib import OK as CHECKER_OK
from export.verify.testlib import Checker, Validator, compile_with, find_testlib
from gen.scenario import parse as parse_input
from gen.scenario import render
from judge.kit.trusted import run_trusted

SEED = 12
QUICK_COUNT, COUNT = 300, 5000  # random files, and random outputs
QUICK_BYTES = 1 << 20  # larger tests take seconds each
# Files to spoil are made of a few small scenarios of each test that is not too large.
SOURCE_BYTES, SOURCE_SCENARIOS, SOURCE_VERTICES = 100_000, 3, 40
MIB = 1 << 20
VERDICTS = {"ok": True, "wrong-answer": False}
IMPORT = """
import asyncio, pathlib, sys
from rbx.box.packaging.polygon.importer import PolygonImporter
package, into = map(pathlib.Path, sys.argv[1:])
asyncio.run(PolygonImporter(main_language=None).import_package(package, into))
"""


def verify(job: Job) -> list[str]:
    """Compare the programs of a package with the kit's own, and let rbx import it.

    quick: fewer random files, and no large tests. Raises VerifyError at the first difference.
    """
    package = job.unpack()
    root = parse(package / "problem.xml").getroot()
    assets, testset = _child(root, "assets"), _child(root, "judging/testset")
    checked, validated = _child(assets, "checker"), _child(assets, "validators/validator")
    work = job.scratch / "work"
    work.mkdir()
    testlib = find_testlib(job.python)
    validator = Validator(compile_with(testlib, package / _source(validated), work / "validator"))
    checker = Checker(compile_with(testlib, package / _source(checked), work / "checker"), work)

    tests = [
        (test, paths)
        for test, paths in _tests(testset, package)
        if not job.quick or paths["input"].stat().st_size <= QUICK_BYTES
    ]
    for test, paths in tests:
        _same(validator, paths["input"], test.get("group"), True)
        if checker.status((paths["input"], paths["answer"], paths["answer"])) != CHECKER_OK:
            raise VerifyError(f"{paths['answer']}: the checker rejects the answer itself")
    validator_tests = list(_tests(_child(validated, "testset"), package))
    for test, paths in validator_tests:
        _same(validator, paths["input"], test.get("group"), test.get("verdict") == "valid")
    checker_tests = list(_tests(_child(checked, "testset"), package))
    for test, paths in checker_tests:
        _same_verdict(checker, paths, VERDICTS[test.get("verdict", "")])

    count = QUICK_COUNT if job.quick else COUNT
    groups = sorted({test.get("group", "") for test, _ in tests})
    small = _small(paths["input"] for _, paths in tests)
    faults = sum(test.get("verdict") == "invalid" for test, _ in validator_tests)
    valid_files = _spoiled(validator, small, [None, *groups], count, work)
    right = _random(checker, count)
    return [
        f"generator: {_generated(tests, package)} large tests, byte for byte",
        f"testlib validator: agrees on {len(tests)} tests, {faults} invalid files, "
        f"{count:,} spoiled files ({valid_files:,} of them valid)",
        f"testlib checker: agrees on {len(checker_tests)} pairs by hand, "
        f"{count:,} random ones ({right:,} of them right)",
        f"rbx: imported {_imported(job.python, package, work / 'rbx', testset)} tests",
    ]


def _generated(tests: Sequence[tuple[Element, dict[str, Path]]], package: Path) -> int:
    """Make every generated test again; return how many. Raises VerifyError for other bytes."""
    count = 0
    for test, paths in tests:
        if test.get("method") == "generated":
            name, *arguments = test.get("cmd", "").split()
            program = package / "files" / f"{name}.py"
            made = run_trusted(name, (sys.executable, "-I", str(program), *arguments))
            if made != paths["input"].read_bytes():
                raise VerifyError(f"{paths['input']}: {test.get('cmd')} writes other bytes")
            count += 1
    return count


def _same(validator: Validator, path: Path, group: str | None, expected: bool) -> None:
    """Raise VerifyError unless both validators say what is expected."""
    content = path.read_bytes()
    for name, passes in (("Polygon's", validator.passes), ("the kit's", valid)):
        if passes(content, group) != expected:
            word = "rejects" if expected else "passes"
            raise VerifyError(f"{path}: {name} validator {word} it (group {group})")


def _same_verdict(checker: Checker, paths: dict[str, Path], expected: bool) -> None:
    """Raise VerifyError unless the checker and the kit's judge say what is expected."""
    output, answer = paths["output"].read_bytes(), paths["answer"].read_bytes()
    verdicts = (checker.accepts(output, answer), accepted(output, answer))
    if verdicts != (expected, expected):
        raise VerifyError(f"{paths['output']}: expected {expected}; checker and kit say {verdicts}")


def _small(paths: Iterable[Path]) -> list[bytes]:
    """Return small valid files, at most one for each test."""
    found = []
    for path in paths:
        if path.stat().st_size <= SOURCE_BYTES:
            scenes = [s for s in parse_input(path.read_bytes()) if s.vertices <= SOURCE_VERTICES]
            if scenes:
                found.append(render(scenes[:SOURCE_SCENARIOS]))
    return found


def _spoiled(
    validator: Validator,
    sources: list[bytes],
    groups: list[str | None],
    count: int,
    scratch: Path,
) -> int:
    """Compare both validators on spoiled files; return how many of these are valid."""
    passed = 0
    for number, content in enumerate(spoiled_inputs(SEED, sources, count)):
        group = groups[number % len(groups)]
        expected = valid(content, group)
        if validator.passes(content, group) != expected:
            kept = scratch / "differs.in"
            kept.write_bytes(content)
            word = "passes" if expected else "rejects"
            raise VerifyError(f"{kept}: only the kit's validator {word} it (group {group})")
        passed += expected
    return passed


def _random(checker: Checker, count: int) -> int:
    """Compare the checker with the kit's judge on random outputs; return how many are right."""
    right = 0
    for output, answer in random_outputs(SEED, count):
        expected = accepted(output, answer)
        if checker.accepts(output, answer) != expected:
            word = "accepts" if expected else "rejects"
            raise VerifyError(f"only the kit {word} output {output!r} for answer {answer!r}")
        right += expected
    return right


def _imported(python: Path, package: Path, into: Path, testset: Element) -> int:
    """Let rbx import the package; return how many tests it read. Raises VerifyError."""
    into.mkdir()
    run_tool((python, "-c", IMPORT, package, into), into)
    found = yaml.safe_load((into / "problem.rbx.yml").read_text(encoding="utf-8"))
    facts = {
        "timeLimit": found["timeLimit"],
        "memoryLimit": found["memoryLimit"] * MIB,
        "tests": len(list(into.glob("tests/*/*.in"))),
        "checker": (into / found["checker"]["path"]).is_file(),
    }
    expected = {
        "timeLimit": int(_text(testset, "time-limit")),
        "memoryLimit": int(_text(testset, "memory-limit")),
        "tests": int(_text(testset, "test-count")),
        "checker": True,
    }
    if facts != expected:
        raise VerifyError(f"rbx: expected {expected}, found {facts}")
    return int(facts["tests"])


def _tests(testset: Element, package: Path) -> Iterator[tuple[Element, dict[str, Path]]]:
    """Yield each test of a test set with its files, by kind."""
    patterns = {
        element.tag.removesuffix("-path-pattern"): element.text or ""
        for element in testset
        if element.tag.endswith("-path-pattern")
    }
    for number, test in enumerate(_child(testset, "tests"), 1):
        yield test, {kind: package / (text % number) for kind, text in patterns.items()}


def _source(program: Element) -> str:
    return _child(program, "source").get("path", "")


def _text(element: Element, path: str) -> str:
    return _child(element, path).text or ""


def _child(element: Element, path: str) -> Element:
    found = element.find(path)
    if found is None:
        raise VerifyError(f"problem.xml: expected {path} in {element.tag}")
    return found
