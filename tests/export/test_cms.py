from __future__ import annotations

import runpy
import sys
from pathlib import Path

import pytest
import yaml

from export.files import Files
from export.package import Package
from export.targets.cms import CHECKER, build
from export.verify.outputs import accepted, random_outputs

TOP = "collisioncourse/"


@pytest.fixture(scope="module")
def files(package: Package) -> Files:
    return build(package)


def test_task_yaml_has_limits_streams_and_public_samples(package: Package, files: Files) -> None:
    task = yaml.safe_load(files.entries[f"{TOP}task.yaml"].read())
    limits = package.problem.limits
    assert (task["time_limit"], task["memory_limit"]) == (limits.time_limit_s, limits.memory_mib)
    assert (task["infile"], task["outfile"]) == ("", "")
    assert task["public_testcases"] == "0,1,2,3"
    for number in range(task["n_input"]):
        assert f"{TOP}input/input{number}.txt" in files.entries
        assert f"{TOP}output/output{number}.txt" in files.entries
    assert f"{TOP}input/input{task['n_input']}.txt" not in files.entries


def test_subtasks_are_the_groups_in_the_order_of_the_inputs(package: Package, files: Files) -> None:
    subtasks: list[tuple[int, list[str]]] = []
    for line in files.entries[f"{TOP}gen/GEN"].read().decode().splitlines():
        if line.startswith("#ST: "):
            subtasks.append((int(line.removeprefix("#ST: ")), []))
        else:
            subtasks[-1][1].append(line)
    assert subtasks == [
        (group.declared.points, [case.name for case in group.cases]) for group in package.groups
    ]
    cases = [case for group in package.groups for case in group.cases]
    for number, case in enumerate(cases):
        assert files.entries[f"{TOP}input/input{number}.txt"].source == case.input


def test_the_statement_is_a_pdf_and_the_checker_a_script(files: Files) -> None:
    assert files.entries[f"{TOP}statement/statement.pdf"].read().startswith(b"%PDF")
    checker = files.entries[f"{TOP}check/checker"]
    assert checker.executable
    assert checker.read().startswith(b"#!/usr/bin/python3")


def test_equal_packages_give_equal_bytes(package: Package, files: Files) -> None:
    again = {name: entry.read() for name, entry in build(package)}
    assert again == {name: entry.read() for name, entry in files}


def test_the_checker_judges_as_the_kit(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    paths = [tmp_path / name for name in ("input", "answer", "output")]
    monkeypatch.setattr(sys, "argv", ["checker", *map(str, paths)])
    seen = set()
    for output, answer in random_outputs(7, 200):
        for path, content in zip(paths, (b"", answer, output), strict=True):
            path.write_bytes(content)
        runpy.run_path(str(CHECKER))
        share, message = capsys.readouterr()
        right = accepted(output, answer)
        seen.add(right)
        assert float(share) == right, (output, answer)
        first, *rest = message.splitlines()
        assert first == ("translate:success" if right else "translate:wrong")
        assert all(line.startswith("ADMIN_MESSAGE:") for line in rest)
    assert seen == {True, False}
