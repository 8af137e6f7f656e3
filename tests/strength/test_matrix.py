"""The kill matrix: verdicts, what is kept, what follows from them, and how it is shown."""

import re

import msgspec
import pytest

from judge.kit.paths import DATA
from judge.kit.store import Store
from judge.languages.submission import SubmissionError
from judge.problem.cases import Case
from judge.problem.data import load_data
from judge.problem.declaration import load
from judge.problem.manifest import Entry, load_manifest, save_manifest, sum_of
from judge.problem.verdict import Verdict
from judge.sandbox.sandbox import Sandbox
from strength.analysis import analyse
from strength.cli import _matrix_command
from strength.order import _ordered, telling_order
from strength.page import page
from strength.show import as_json
from strength.table import Matrix, Row, build

PROBLEM = load()
YES, NO = "wrong_answer/always_yes.py", "wrong_answer/always_no.py"
AC, WA, TLE = Verdict.AC, Verdict.WA, Verdict.TLE


@pytest.fixture
def store(tmp_path):
    with Store(tmp_path / "store.sqlite") as store:
        yield store


def case_with(directory, number, content, answer):
    """Write a case, and return its entry of the manifest."""
    path = directory / f"secret/small/{number}.in"
    path.write_bytes(content)
    path.with_suffix(".ans").write_bytes(answer)
    return Entry("", {}, 0, 0, sum_of(content), sum_of(answer), 1, 3, 0, 1, 0)


@pytest.fixture
def data(tmp_path):
    """One case with the answer YES, one with NO; the programs read only the first number."""
    (tmp_path / "secret/small").mkdir(parents=True)
    for number, answer in (("1", b"YES\n"), ("2", b"NO\n")):
        change(tmp_path, number, b"1\n", answer)
    return tmp_path


def change(directory, number, content, answer):
    entries = load_manifest(directory).cases
    entry = case_with(directory, number, content, answer)
    save_manifest(directory, entries | {f"secret/small/{number}": entry})


def matrix_of(data, store, problem=PROBLEM):
    with Sandbox() as sandbox:
        return build([YES, NO], load_data(problem, data), problem, sandbox, store, jobs=2)


def test_verdicts_are_judged_once_and_again_when_a_file_changes(data, store):
    first = matrix_of(data, store)
    assert [list(row.verdicts.values()) for row in first.rows] == [[AC, WA], [WA, AC]]
    assert first.judged == 4
    again = matrix_of(data, store)
    assert (again.rows, again.judged) == (first.rows, 0)
    change(data, "1", b"2\n", b"NO\nNO\n")
    changed = matrix_of(data, store)
    assert [list(row.verdicts.values()) for row in changed.rows] == [[WA, WA], [AC, AC]]
    assert changed.judged == 2


def test_other_limits_are_judged_again(data, store):
    matrix_of(data, store)
    limits = msgspec.structs.replace(PROBLEM.limits, time_limit_s=6.0)
    other = msgspec.structs.replace(PROBLEM, limits=limits)
    assert matrix_of(data, store, other).judged == 4


def test_kept_verdicts_that_are_damaged_are_judged_again(data, tmp_path):
    path = tmp_path / "store.sqlite"
    with Store(path) as store:
        first = matrix_of(data, store)
    path.write_bytes(b"{" * 5_000)
    with Store(path) as store:
        again = matrix_of(data, store)
    assert (again.rows, again.judged) == (first.rows, 4)


def made(**verdicts):
    """A matrix of made-up verdicts: two cases each of small and large."""
    names = ["secret/small/1", "secret/small/2", "secret/large/1", "secret/large/2"]
    cases = tuple(Case(n, n.split("/")[1], DATA / n, DATA / n) for n in names)
    rows = tuple(
        Row(f"wrong_answer/{name}", {n: v for n, v in zip(names, found, strict=True) if v})
        for name, found in verdicts.items()
    )
    return Matrix(rows, cases, 0)


def declared(**groups):
    """The problem with only the groups small and large, and only these declarations."""
    names = {f"wrong_answer/{name}": expected for name, expected in groups.items()}
    kept = [group for group in PROBLEM.groups if group.name in ("small", "large")]
    return msgspec.structs.replace(PROBLEM, groups=kept, folders={}, submissions=names)


def test_findings():
    matrix = made(a=[WA, AC, WA, WA], b=[WA, WA, TLE, None], c=[AC, AC, WA, AC])
    problem = declared(
        a={"small": "WA", "large": "WA"},
        b={"small": "WA", "large": "TLE"},
        c={"large": "WA"},
    )
    families = {"secret/small/1": "tiny", "secret/small/2": "tiny", "secret/large/1": "rooms"}
    found = analyse(matrix, problem, families)
    assert found.only_killer == {"secret/large/1": ("wrong_answer/c",)}
    assert found.only_in_group == {
        "secret/small/1": ("wrong_answer/a",),
        "secret/large/1": ("wrong_answer/c",),
    }
    assert found.needless == ("secret/small/2", "secret/large/2")
    assert found.families["wrong_answer/b"] == {"tiny": 2, "rooms": 1}
    assert found.faults == (
        "wrong_answer/c: expected at least 3 cases that kill it, found secret/large/1",
    )


def test_a_group_that_is_not_as_declared_is_a_fault():
    found = analyse(made(a=[WA, WA, WA, AC]), declared(a={"small": "WA"}), {})
    assert found.faults == ("wrong_answer/a: large: expected AC, found WA",)
    assert not found.cells["wrong_answer/a"]["large"].as_declared


def test_few_kills_are_no_fault_when_only_some_groups_were_judged():
    matrix = made(a=[WA, AC, AC, AC])
    small = Matrix(matrix.rows, matrix.cases[:2], 0)
    assert analyse(small, declared(a={"small": "WA"}), {}).faults == ()


def test_the_page_needs_nothing_else_and_escapes_what_it_shows():
    matrix = made(**{"<b>": [WA, AC, WA, TLE]})
    analysis = analyse(matrix, declared(**{"<b>": {"small": "WA"}}), {})
    text = page(matrix, analysis, {})
    assert "<b>" not in text
    assert "&lt;b&gt;" in text
    assert not re.search(r"<script|<link|src=|href=|url\(|@import|http", text)
    assert text.count('class="WA" title="WA"') == 2
    assert 'class="TLE" title="TLE"' in text


def test_json_holds_every_verdict():
    matrix = made(a=[WA, AC, WA, TLE])
    content = msgspec.json.decode(as_json(matrix, analyse(matrix, declared(a={}), {})))
    assert content["version"] == 1
    assert list(content["submissions"][0]["cases"].values()) == ["WA", "AC", "WA", "TLE"]
    assert content["submissions"][0]["groups"]["small"]["killed"] == 1


def test_the_order_of_judging_takes_what_kills_most_for_its_cost():
    """Until all are killed; then all count again. What kills nothing comes last, small first."""
    matrix = made(a=[WA, AC, WA, AC], b=[WA, AC, AC, AC], c=[AC, WA, AC, AC], d=[AC, AC, AC, AC])
    sizes = {case.name: 10 for case in matrix.cases}
    assert telling_order(matrix, sizes) == [
        f"secret/{n}" for n in ("small/1", "small/2", "large/1", "large/2")
    ]
    costly = sizes | {"secret/small/1": 10_000_000}
    assert telling_order(matrix, costly)[:2] == ["secret/small/2", "secret/small/1"]
    three = {"x": {"a", "b"}, "y": {"a", "b"}, "z": {"c"}}
    assert list(_ordered(list(three), three, dict.fromkeys(three, 10))) == ["x", "z", "y"]
    again = made(a=[WA, WA, AC, WA], b=[WA, AC, AC, AC], c=[WA, WA, AC, WA])
    assert telling_order(again, sizes)[2:] == ["secret/large/2", "secret/large/1"]
    with pytest.raises(SubmissionError, match="--order: expected all submissions"):
        _matrix_command(["--order", YES])
