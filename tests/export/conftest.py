"""A small package for all tests of exports."""

from __future__ import annotations

from dataclasses import replace

import pytest

from export import package as source
from export.package import Package, load_package
from judge.kit.paths import DATA
from judge.problem.order import judging_order

CASES = 2  # of every group but the samples, which are small
TELLING = 4


@pytest.fixture(scope="session")
def package() -> Package:
    """A package with the samples and two small cases of each group."""
    whole = load_package()

    def smallest(group: source.TestGroup) -> source.TestGroup:
        by_size = sorted(group.cases, key=lambda case: case.input.stat().st_size)
        return replace(group, cases=tuple(by_size[:CASES]))

    secret = map(smallest, whole.secret)
    samples = next(group for group in whole.groups if group.name == "sample")
    return replace(whole, groups=(samples, *secret))


@pytest.fixture(scope="session")
def telling() -> Package:
    """A compact package: of each group, the cases that are judged first, as they tell most."""
    whole = load_package()
    groups = (
        replace(group, cases=tuple(judging_order(DATA, group.cases)[:TELLING]))
        for group in whole.groups
    )
    return replace(whole, groups=tuple(groups), compact=True)
