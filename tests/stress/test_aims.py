"""Every wrong submission has a counterexample as small as can be; seconds do not count."""

import pytest

from judge.kit.paths import ROOT
from judge.problem.declaration import load
from stress.search import result
from stress.search.table import TABLE, rows_of, wrong_submissions

# What needs large polygons: the least vertices that any scenario that it gets wrong has.
LARGE = {
    "run_time_error/array_too_small.cpp",
    "run_time_error/deep_recursion.py",
    "wrong_answer/bisection_of_16_steps.cpp",
    "wrong_answer/edges_of_large_robots_skipped.cpp",
    "wrong_answer/robot_cut_to_100000.cpp",
}
# What needs large numbers: it rounds, or overflows.
LONG = {
    "wrong_answer/angles_by_atan2.py",
    "wrong_answer/axes_in_doubles.cpp",
    "wrong_answer/directions_by_slope.cpp",
    "wrong_answer/directions_in_doubles.cpp",
    "wrong_answer/distance_with_eps.cpp",
    "wrong_answer/doubles.cpp",
    "wrong_answer/doubles_with_eps.py",
    "wrong_answer/infinity_too_small.cpp",
    "wrong_answer/int32_products.cpp",
    "wrong_answer/int32_turn_of_edges.cpp",
    "wrong_answer/intersection_points.py",
    "wrong_answer/long_double_distance.cpp",
}
TWO_OBSTACLES = 9  # vertices of a robot and two obstacles, at least


def test_the_table_names_every_wrong_submission():
    text = TABLE.read_text(encoding="utf-8")
    assert [name for name in wrong_submissions(load()) if f"| `{name}` |" not in text] == []
    assert text.count("\n| `") == len(wrong_submissions(load()))
    assert TABLE.is_relative_to(ROOT)


@pytest.mark.slow
@pytest.mark.usefixtures("compiled_once")
@pytest.mark.parametrize("name", wrong_submissions(load()))
def test_the_counterexample_is_as_small_as_the_bug_permits(name, tmp_path, monkeypatch):
    monkeypatch.setattr(result, "COUNTEREXAMPLES", tmp_path)
    (row,) = rows_of([name], load(), seed=1, jobs=2)
    found = row.found
    assert found is not None, row.why
    if name not in LARGE:
        assert found.obstacles <= 2
        assert found.vertices <= (TWO_OBSTACLES if found.obstacles == 2 else 8)
    if name not in LARGE | LONG:
        assert row.largest < 20
