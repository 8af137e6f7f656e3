"""What several tests of the generators share."""

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from gen.added import load_added
from gen.cli import main
from judge.kit.paths import DATA


@pytest.fixture
def data(tmp_path: Path) -> Path:
    """A copy of the committed part of the data, without the cases that a user added."""
    copy = tmp_path / "data"
    shutil.copytree(DATA, copy, ignore=shutil.ignore_patterns("large", "many", "invalid_input"))
    for recipe in load_added(copy):
        assert run_gen("remove", recipe.case_name, "--data", copy) == 0
    return copy


def run_gen(*arguments: object) -> int:
    return main([str(argument) for argument in arguments])


@pytest.fixture(name="gen")
def gen_fixture() -> Callable[..., int]:
    """Runs one command of `python -m gen` in this process; returns its exit status."""
    return run_gen
