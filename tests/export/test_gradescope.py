"""The zip for Gradescope: what is in it, and that it works where it is unpacked."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from export.package import Package, load_package
from export.targets.gradescope import TARGETS
from export.verify import gradescope
from export.verify.gradescope import hostile, lay_out, read_results, set_up, trials, tried
from export.verify.job import VerifyError

(TARGET,) = TARGETS


def test_no_large_input_is_in_it() -> None:
    files = TARGET.build(load_package())
    names = set(files.entries)
    assert {"setup.sh", "run_autograder", "kit/solution.py", "kit/data/manifest.json"} <= names
    assert "kit/data/secret/large/01-largest.in" not in names
    assert "kit/data/secret/large/01-largest.ans" in names
    assert files.size < 20 << 20
    assert files.entries["setup.sh"].executable
    assert files.entries["run_autograder"].executable


def test_no_submission_is_in_it_that_is_not_needed() -> None:
    names = [name for name in TARGET.build(load_package()).entries if "/submissions/" in name]
    assert names == [
        "kit/submissions/accepted/separating_axis.py",
        "kit/submissions/accepted/textbook.py",
    ]


def test_the_manifest_holds_the_chosen_cases_and_the_calibration_case(telling: Package) -> None:
    files = TARGET.build(telling)
    manifest = json.loads(files.entries["kit/data/manifest.json"].read())
    chosen = {case.name for group in telling.groups for case in group.cases}
    assert set(manifest["cases"]) == chosen | {telling.problem.calibration.case}
    assert "'secret/large/01-largest'" in files.entries["kit/prepare.sh"].read().decode()


def test_what_is_left_if_the_judging_is_ended_blames_nobody(telling: Package) -> None:
    results = read_results(TARGET.build(telling).entries["unfinished.json"].read())
    assert "score" not in results


@pytest.mark.parametrize(
    "content", ["", "{", '{"output": "x"}', '{"tests": [{"score": "1"}]}', '{"scores": 1}']
)
def test_the_verification_refuses_what_is_not_documented(content: str) -> None:
    with pytest.raises(VerifyError, match=r"results\.json: "):
        read_results(content.encode())


@pytest.mark.slow
def test_it_works_where_it_is_unpacked(telling: Package, tmp_path: Path) -> None:
    """With the first cases of each group only; `verify` does the same with all of them."""
    zipped = tmp_path / "gradescope.zip"
    TARGET.build(telling).write_zip(zipped)
    place = lay_out(zipped, tmp_path / "autograder")
    set_up(place)
    for trial in [*trials(), *hostile(place)]:
        if trial.name != "a slow program":  # the search for a small counterexample takes a minute
            tried(place, trial)
    (place / "source" / "kit" / "data" / "sample" / "01-first.ans").unlink()
    broken = gradescope.graded(place, {"a.py": "print(1)"})
    assert "score" not in broken
