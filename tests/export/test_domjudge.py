"""The DOMjudge zip: no top folder, what its importer reads, one certain verdict a submission."""

from __future__ import annotations

import pytest
import yaml

from export.files import Files
from export.package import Package
from export.targets import TARGETS
from export.targets.domjudge import MARK


@pytest.fixture(scope="module")
def files(package: Package) -> Files:
    return TARGETS["domjudge"].build(package)


def test_names_and_limits(files: Files, package: Package) -> None:
    limits = package.problem.limits
    table = yaml.safe_load(files.entries["problem.yaml"].read())
    assert table["limits"] == {
        "time_limit": limits.time_limit_s,
        "memory": limits.memory_mib,
        "output": limits.output_mib,
    }
    assert float(files.entries[".timelimit"].read()) == limits.time_limit_s
    assert "externalid = collisioncourse" in files.entries["domjudge-problem.ini"].read().decode()
    assert files.entries["problem.pdf"].read().startswith(b"%PDF")


def test_cases_are_pairs_with_a_description(files: Files, package: Package) -> None:
    inputs = [name for name in files.entries if name.endswith(".in")]
    assert len(inputs) == sum(len(group.cases) for group in package.groups)
    for name in inputs:
        assert f"{name.removesuffix('.in')}.ans" in files.entries
        assert files.entries[f"{name.removesuffix('.in')}.desc"].read().strip()
    secret = [name for name in inputs if "/secret/" in name]
    assert sorted(secret) == secret or {name.count("/") for name in secret} == {2}


def test_marks_agree_with_folders(files: Files, package: Package) -> None:
    marked = [name for name in files.entries if name.startswith("submissions/")]
    certain = [each for each in package.submissions if len(each.overall) == 1]
    assert len(marked) == len(certain)
    for name in marked:
        text = files.entries[name].read().decode()
        assert text.count(MARK) == 1
        assert text.rstrip().endswith(f"{MARK}: {name.split('/')[1].upper()}")
