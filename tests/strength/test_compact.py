"""The small selection of cases: how it is chosen, and that data/compact.json is current."""

import msgspec
import pytest

from judge.kept import KeptVerdicts
from judge.kit.paths import DATA, SUBMISSIONS
from judge.kit.store import Store
from judge.languages.submission import read_submission
from judge.problem.cases import Case
from judge.problem.compact import compact_cases
from judge.problem.data import load_data
from judge.problem.declaration import load
from judge.problem.manifest import Entry, FileSum
from judge.problem.verdict import Verdict
from judge.sandbox.facts import RunLimits
from strength.analysis import FEWEST_KILLS
from strength.compact.choose import Demand, choose, cover, kills
from strength.compact.show import weak
from strength.compact.slow import further_runs
from strength.table import Matrix, Row

PROBLEM = load()
AC, WA, TLE = Verdict.AC, Verdict.WA, Verdict.TLE


def demand(names, need=1):
    return Demand(frozenset(names), need)


def test_light_cases_that_meet_many_demands_are_taken():
    weights = {"a": 10, "b": 10, "c": 10, "heavy": 1000}
    demands = [demand(["a", "heavy"]), demand(["a", "b"]), demand(["b", "heavy"])]
    assert cover(demands, weights) == {"a", "b"}


def test_every_demand_is_met_as_often_as_it_says():
    weights = dict.fromkeys("abcd", 10)
    demands = [demand("abcd", 3), demand("d", 1)]
    chosen = cover(demands, weights)
    assert len(chosen) == 3
    assert "d" in chosen


def test_what_later_choices_make_needless_is_dropped():
    """The greedy rule takes `both` first; `x` and `y` are needed for others, and meet all."""
    weights = dict.fromkeys(["both", "x", "y"], 3)
    shared = [demand(["both", "x"]), demand(["both", "y"])]
    demands = [*shared, *shared, demand("x"), demand("y")]
    assert cover(demands, weights) == {"x", "y"}


def entry(size, vertices):
    return Entry("", {}, 0, 0, FileSum(size, ""), FileSum(1, ""), 1, vertices, vertices, 0, 1)


def made(**verdicts):
    """A matrix of made-up verdicts on five cases of the group large; "-" was not run."""
    names = [f"secret/large/{number}" for number in range(5)]
    cases = tuple(Case(name, "large", DATA / name, DATA / name) for name in names)
    rows = tuple(
        Row(f"wrong_answer/{name}", {n: v for n, v in zip(names, found, strict=True) if v != "-"})
        for name, found in verdicts.items()
    )
    return Matrix(rows, cases, 0)


def declared(**groups):
    names = {f"wrong_answer/{name}": {"large": expected} for name, expected in groups.items()}
    return msgspec.structs.replace(PROBLEM, folders={}, submissions=names)


def test_three_killers_stay_and_the_largest_case():
    matrix = made(a=[WA, WA, WA, WA, AC], b=[AC, AC, AC, WA, AC])
    entries = {case.name: entry(1000, 100) for case in matrix.cases}
    entries["secret/large/4"] = entry(10**6, 500)
    problem = declared(a="WA", b="WA")
    seconds = dict.fromkeys(entries, 0.02)
    chosen = choose(matrix, problem, entries, seconds)["large"]
    assert len(chosen) == FEWEST_KILLS + 1
    assert {"secret/large/3", "secret/large/4"} < set(chosen)
    assert list(weak(matrix, problem, ["large"], set(chosen))) == [
        "wrong_answer/b: large: 1 killer, all 1 that are known"
    ]


def test_only_declared_verdicts_count():
    matrix = made(a=[TLE, WA, WA, AC, AC])
    (found,) = kills(matrix, declared(a="WA"), "large")
    assert found.cases == {"secret/large/1", "secret/large/2"}


def test_a_slow_submission_runs_on_large_cases_until_two_stop_it(monkeypatch):
    matrix = made(a=[TLE, "-", "-", "-", "-"])
    sizes = [(9, 500), (3, 400), (2, 10), (1, 450), (8, 480)]
    entries = {c.name: entry(*size) for c, size in zip(matrix.cases, sizes, strict=True)}

    class Made:
        chosen = matrix.cases
        manifest = type("M", (), {"cases": entries})

    further = further_runs(Made, declared(a="TLE"))
    verdicts = dict(matrix.rows[0].verdicts)
    first = further("wrong_answer/a", "large", verdicts)
    assert first.name == "secret/large/3"  # the smallest file of the large cases
    assert further("wrong_answer/a", "large", verdicts | {first.name: AC}).name.endswith("/1")
    assert further("wrong_answer/a", "large", verdicts | {first.name: TLE}) is None
    wrong = further_runs(Made, declared(a="WA"))
    assert wrong("wrong_answer/a", "large", verdicts).name == "secret/large/2"


@pytest.fixture(scope="module")
def kept():
    """All cases, the names of the selection, and what is kept of the submissions' verdicts."""
    declared = PROBLEM.limits
    limits = RunLimits(declared.time_limit_s, declared.memory_mib, declared.output_mib)
    with Store() as store:
        data = load_data(PROBLEM, store=store)
        rows = tuple(
            Row(
                name,
                KeptVerdicts(
                    store, read_submission(SUBMISSIONS / name), limits, data.manifest
                ).look_up(data.chosen),
            )
            for name in PROBLEM.submissions
        )
    names = {case.name for case in compact_cases(DATA, data.all)}
    return Matrix(rows, data.chosen, 0), names


def test_the_selection_keeps_the_declared_kills_that_are_known(kept):
    """No group that a declared submission fails is passed with the selection alone."""
    matrix, names = kept
    for group in PROBLEM.group_names:
        here = [case.name for case in matrix.cases if case.group == group]
        for row in matrix.rows:
            if all(name in row.verdicts for name in here):
                killers = {name for name in here if row.verdicts[name] is not AC}
                enough = min(FEWEST_KILLS, len(killers))
                assert len(killers & names) >= enough, (row.submission, group)


def test_the_selection_has_the_samples_and_is_small(kept):
    matrix, names = kept
    assert {case.name for case in matrix.cases if case.group == "sample"} <= names
    size = sum(case.input.stat().st_size for case in matrix.cases)
    assert sum(c.input.stat().st_size for c in matrix.cases if c.name in names) < size / 2
