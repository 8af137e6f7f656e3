from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path
from shutil import which
from xml.etree import ElementTree

import pytest

from export.files import Files
from export.package import Package
from export.targets.polygon import build, generator
from export.targets.polygon.descriptor import descriptor
from export.targets.polygon.programs import CHECKER_TESTS, validator
from export.verify.job import Job, VerifyError, need
from export.verify.outputs import accepted
from export.verify.polygon import verify
from export.verify.testlib import find_testlib
from judge.problem.declaration import Group


@pytest.fixture(scope="module")
def files(package: Package) -> Files:
    return build(package)


@pytest.fixture(scope="module")
def described(files: Files) -> ElementTree.Element:
    return ElementTree.fromstring(files.entries["problem.xml"].read())


def test_problem_xml_names_files_that_are_there(
    files: Files, described: ElementTree.Element
) -> None:
    paths = {node.get("path", "") for node in described.iter() if node.get("path")}
    for testset in described.iter("testset"):
        count = int(testset.findtext("test-count", ""))
        assert count == len(testset.findall("tests/test"))
        for pattern in testset:
            if pattern.tag.endswith("-path-pattern"):
                paths |= {(pattern.text or "") % number for number in range(1, count + 1)}
    assert len(paths) > 100
    assert paths - files.entries.keys() == set()
    rest = files.entries.keys() - paths
    assert {name.partition("/")[0] for name in rest} == {
        "problem.xml",
        "statements",
        "statement-sections",
    }


def test_the_points_of_a_group_are_those_of_its_tests(
    package: Package, described: ElementTree.Element
) -> None:
    points = {
        group.name: sum(
            float(test.get("points", ""))
            for test in described.findall("judging/testset/tests/test")
            if test.get("group") == group.name
        )
        for group in package.groups
    }
    assert points == {group.name: group.declared.points for group in package.groups}
    for group in described.findall("judging/testset/groups/group"):
        assert group.get("points-policy") == "complete-group"
        assert float(group.get("points", "")) == points[group.get("name", "")]


def test_limits_samples_and_tags(package: Package, described: ElementTree.Element) -> None:
    limits = package.problem.limits
    assert described.findtext("judging/testset/time-limit") == str(int(limits.time_limit_s * 1000))
    assert described.findtext("judging/testset/memory-limit") == str(limits.memory_mib << 20)
    tests = described.findall("judging/testset/tests/test")
    assert [test.get("sample") for test in tests][:5] == ["true"] * 4 + [None]
    tags = {
        str(node[0].get("path")): node.get("tag")
        for node in described.findall("assets/solutions/solution")
    }
    assert [path for path, tag in tags.items() if tag == "main"] == ["solutions/solution.py"]
    assert tags["solutions/chord_across_edge.cpp"] == "accepted"
    assert tags["solutions/textbook.cpp"] == "time-limit-exceeded"
    assert tags["solutions/doubles.cpp"] == "wrong-answer"
    assert tags["solutions/exit_code_3.py"] == "rejected"
    assert "solutions/missing_semicolon.cpp" not in tags


def test_validator_tests_are_the_samples_and_the_invalid_files(
    package: Package, described: ElementTree.Element
) -> None:
    tests = described.findall("assets/validators/validator/testset/tests/test")
    assert [test.get("verdict") for test in tests] == ["valid"] * len(package.samples) + [
        "invalid"
    ] * len(package.invalid_inputs)
    held = [test.get("group", "") for test in tests[len(package.samples) :]]
    assert held == [fault.group for fault in package.invalid_inputs]


def test_constants_of_the_validator_are_those_of_problem_toml(package: Package) -> None:
    source = validator(package.problem)
    constants = dict(re.findall(r"^const int ([A-Z_]+) = (\d+);", source, re.M))
    bounds = package.problem.constraints
    assert {name: int(value) for name, value in constants.items()} == {
        name.upper(): getattr(bounds, name) for name in type(bounds).__struct_fields__
    }
    promises = dict(re.findall(r'^    \{"(\w+)", \{(.*)\}\},$', source, re.M))

    def promise(group: Group) -> str:
        vertices, pairs = group.max_vertices or "MAX_VERTICES", group.max_pair_sum or "LLONG_MAX"
        return f"{vertices}, {pairs}, {str(group.zero_displacement).lower()}"

    assert promises == {group.name: promise(group) for group in package.problem.groups}


def test_the_generator_is_one_file_that_makes_the_bytes_of_a_case(
    package: Package, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(generator, "TEXT_BYTES", 0)
    case = package.secret[0].cases[0]
    name = generator.arguments(case)
    recipe = generator.recipes(package)[name]
    program = tmp_path / "generator.py"
    program.write_text(generator.source(package, {name: recipe}))
    command = [sys.executable, "-I", str(program), *name.split()]
    made = subprocess.run(command, capture_output=True, cwd=tmp_path, check=True)
    assert made.stdout == case.input.read_bytes()
    unknown = subprocess.run(command[:-1], capture_output=True, text=True, check=False)
    assert unknown.returncode == 1
    assert f"expected one of: {name}" in unknown.stderr


def test_large_tests_are_generated(monkeypatch: pytest.MonkeyPatch, package: Package) -> None:
    monkeypatch.setattr(generator, "TEXT_BYTES", 0)
    tests = ElementTree.fromstring(descriptor(package)).findall("judging/testset/tests/test")
    by_hand = len(package.samples)
    assert [test.get("method") for test in tests[:by_hand]] == ["manual"] * by_hand
    for test, case in zip(
        tests[by_hand:], (case for group in package.secret for case in group.cases), strict=True
    ):
        assert test.get("method") == "generated"
        assert test.get("cmd") == f"generator {case.group} {case.input.stem}"


@pytest.mark.parametrize("test", CHECKER_TESTS)
def test_checker_tests_have_the_verdict_of_the_kits_judge(test: tuple[str, str, str]) -> None:
    output, answer, verdict = test
    assert accepted(output.encode(), answer.encode()) == (verdict == "ok")


def test_statement_has_every_section_and_figure(files: Files) -> None:
    document = files.entries["statements/english/problem.tex"].read().decode()
    order = [r"\InputFile", r"\OutputFile", r"\Scoring", r"\Examples", r"\Note", r"\end{problem}"]
    places = [document.index(heading) for heading in order]
    assert places == sorted(places)
    figures = re.findall(r"\\includegraphics\[.*\]\{(.*)\}", document)
    assert len(figures) == 4
    for folder in ("statements", "statement-sections"):
        for name in figures:
            assert files.entries[f"{folder}/english/{name}"].read().startswith(b"%PDF")
        assert f"{folder}/english/example.04.a" in files.entries
    for name in ("name", "legend", "input", "output", "scoring", "notes"):
        section = files.entries[f"statement-sections/english/{name}.tex"].read().decode()
        assert section in document


def test_equal_packages_give_equal_bytes(package: Package, files: Files) -> None:
    again = {name: entry.read() for name, entry in build(package)}
    assert again == {name: entry.read() for name, entry in files}


def test_an_environment_without_testlib_is_named() -> None:
    with pytest.raises(VerifyError, match=r"tools/setup\.py --judges"):
        find_testlib(Path(which("false") or ""))


@pytest.mark.slow
def test_testlibs_programs_agree_with_the_kit(files: Files, tmp_path: Path) -> None:
    archive = tmp_path / "polygon.zip"
    files.write_zip(archive)
    scratch = tmp_path / "scratch"
    scratch.mkdir()
    job = Job(archive, scratch, quick=True)
    try:
        find_testlib(job.python)
        need("g++", "g++")
    except VerifyError as error:
        pytest.skip(str(error))
    assert [line.partition(":")[0] for line in verify(job)] == [
        "generator",
        "testlib validator",
        "testlib checker",
        "rbx",
    ]
