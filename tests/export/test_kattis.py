"""The Kattis formats: the packages say what problem.toml says."""

from __future__ import annotations

import subprocess
import sys
from functools import partial
from pathlib import Path
from typing import Any

import pytest
import yaml

from export.files import Files
from export.package import Package
from export.targets import TARGETS
from judge.problem.verdict import Verdict

TOP = "collisioncourse/"
GROUPS = {"static": "1-static", "small": "2-small", "large": "3-large", "many": "4-many"}
CERTAIN = {"wrong_answer": "WA", "time_limit_exceeded": "TLE", "run_time_error": "RTE"}


@pytest.fixture(scope="module")
def built(package: Package) -> dict[str, Files]:
    names = ("kattis", "kattis-pass-fail", "bapctools", "kattis-2025")
    return {name: TARGETS[name].build(package) for name in names}


def table(files: Files, name: str) -> dict[str, Any]:
    loaded: dict[str, Any] = yaml.safe_load(files.entries[TOP + name].read())
    return loaded


def folders(files: Files) -> dict[str, str]:
    """Return the folder of each submission by the name of its file."""
    names = [name.split("/") for name in files.entries if name.startswith(f"{TOP}submissions/")]
    return {name[3]: name[2] for name in names if len(name) == 4}


@pytest.mark.parametrize("target", ["kattis", "kattis-pass-fail", "bapctools", "kattis-2025"])
def test_all_packages_have_the_same_data(
    built: dict[str, Files], package: Package, target: str
) -> None:
    files = built[target]
    for group in package.groups:
        below = "sample" if group.name == "sample" else f"secret/{GROUPS[group.name]}"
        for case in group.cases:
            for path in (case.input, case.answer):
                entry = files.entries[f"{TOP}data/{below}/{path.name}"]
                assert entry.read() == path.read_bytes()
    assert all(name.startswith(TOP) for name in files.entries)


def test_each_package_is_a_problem_of_its_own(built: dict[str, Files], package: Package) -> None:
    uuids = {table(files, "problem.yaml")["uuid"] for files in built.values()}
    assert len(uuids) == 4
    assert package.problem.uuid not in uuids


def test_limits_are_the_declared_ones(built: dict[str, Files], package: Package) -> None:
    limits = package.problem.limits
    for files in built.values():
        found = table(files, "problem.yaml")["limits"]
        assert found["memory"] == limits.memory_mib
        assert found["output"] == limits.output_mib
        assert found["code"] == limits.code_kib
    new = table(built["bapctools"], "problem.yaml")["limits"]
    assert new["time_limit"] == limits.time_limit_s


def test_points_by_group(built: dict[str, Files], package: Package) -> None:
    for group in package.secret:
        below = f"data/secret/{GROUPS[group.name]}"
        points = group.declared.points
        legacy = table(built["kattis"], f"{below}/testdata.yaml")
        assert legacy["accept_score"] == points
        assert legacy["range"] == f"0 {points}"
        assert (legacy["grader_flags"], legacy["on_reject"]) == ("min", "break")
        new = table(built["kattis-2025"], f"{below}/test_group.yaml")
        assert (new["max_score"], new["score_aggregation"]) == (points, "pass-fail")
        for name in ("kattis-pass-fail", "bapctools"):
            file = "testdata.yaml" if name == "kattis-pass-fail" else "test_group.yaml"
            assert list(table(built[name], f"{below}/{file}")) in (
                ["input_validator_flags"],
                ["input_validator_args"],
            )
    assert table(built["kattis"], "data/testdata.yaml")["range"] == "0 100"
    assert table(built["kattis-2025"], "data/secret/test_group.yaml")["max_score"] == 100


def test_submissions_stand_where_their_verdict_is(
    built: dict[str, Files], package: Package
) -> None:
    coarse = {Verdict.MLE: Verdict.RTE, Verdict.OLE: Verdict.RTE}
    scoring, legacy, new = (
        folders(built[name]) for name in ("kattis", "kattis-pass-fail", "bapctools")
    )
    for submission in package.submissions:
        verdicts = {coarse.get(verdict, verdict).value for verdict in submission.overall}
        if verdicts == {"CE"}:
            assert submission.file not in new
            continue
        if verdicts == {"AC"}:
            assert {each[submission.file] for each in (scoring, legacy, new)} == {"accepted"}
            continue
        if len(verdicts) > 1:
            assert new[submission.file] == "rejected"
            assert submission.file not in legacy
        else:
            assert {CERTAIN[new[submission.file]]} == verdicts
            assert legacy[submission.file] == new[submission.file]
        if package.points(submission):
            assert scoring[submission.file] == "partially_accepted"
    assert new["solution.py"] == "accepted"
    assert new["brute.py"] == new["textbook.py"] == "time_limit_exceeded"


def test_expectations_are_the_declared_ones(built: dict[str, Files], package: Package) -> None:
    expectations = table(built["bapctools"], "submissions/submissions.yaml")
    known = folders(built["bapctools"])
    assert {name.partition("/")[2] for name in expectations} == {
        file for file, folder in known.items() if folder != "accepted"
    }
    textbook = expectations["time_limit_exceeded/textbook.py"]
    assert textbook["permitted"] == ["AC", "TLE"]
    assert textbook["required"] == ["TLE"]
    accepted = [key for key, entry in textbook.items() if isinstance(entry, dict)]
    assert accepted == ["sample", "secret/1-static", "secret/2-small", "secret/3-large"]
    sampled = expectations["rejected/motion_sampled.py"]
    assert sampled["required"] == ["WA", "TLE"]
    assert sampled["use_for_time_limit"] is False


def test_descriptions_and_hints(built: dict[str, Files], package: Package) -> None:
    files = built["bapctools"]
    described = [
        table(files, f"data/secret/{GROUPS[group.name]}/{case.input.stem}.yaml")
        for group in package.secret
        for case in group.cases
    ]
    assert len(described) == 8
    assert all("scenario" in each["description"] for each in described)


@pytest.fixture(scope="module")
def programs(built: dict[str, Files], tmp_path_factory: pytest.TempPathFactory) -> partial[int]:
    """A function that runs a program of the package and returns its exit status."""
    directory = tmp_path_factory.mktemp("programs")
    files = Files()
    for name, entry in built["bapctools"]:
        if "validators/" in name:
            files.add(name.removeprefix(TOP), entry.source)
    files.write_directory(directory / "package")

    def run(program: str, *arguments: str, content: bytes) -> int:
        path = next((directory / "package" / f"{program}s").rglob("main.py"))
        command = [sys.executable, str(path), *arguments]
        return subprocess.run(command, input=content, capture_output=True, check=False).returncode

    return partial(run)


def test_the_input_validator_rejects_what_the_kit_rejects(
    programs: partial[int], package: Package
) -> None:
    for invalid in package.invalid_inputs[::5]:
        group = ("--group", invalid.group) if invalid.group else ()
        content = invalid.path.read_bytes()
        assert programs("input_validator", *group, content=content) == 43, invalid.name
    for sample in package.samples:
        content = sample.input.read_bytes()
        assert programs("input_validator", "--group", "sample", content=content) == 42


@pytest.mark.slow
def test_the_input_validator_on_every_invalid_input(
    programs: partial[int], package: Package
) -> None:
    for invalid in package.invalid_inputs:
        group = ("--group", invalid.group) if invalid.group else ()
        content = invalid.path.read_bytes()
        assert programs("input_validator", *group, content=content) == 43, invalid.name


@pytest.mark.parametrize(
    ("answer", "status"),
    [(b"YES\nNO\n", 42), (b"YES\n", 43), (b"YES\nNO", 43), (b"YES\nno\n", 43), (b"", 43)],
)
def test_the_answer_validator(
    programs: partial[int], package: Package, answer: bytes, status: int
) -> None:
    sample: Path = package.samples[0].input  # has two scenarios
    assert programs("answer_validator", str(sample), content=answer) == status
