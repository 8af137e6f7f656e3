"""The store: what is kept, by several processes at once, also when its file is of no use."""

from __future__ import annotations

import os
import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest

from judge.kept import KeptVerdicts
from judge.kit.paths import ROOT
from judge.kit.store import Store
from judge.languages.submission import Submission
from judge.languages.table import by_name
from judge.problem.cases import Case
from judge.problem.manifest import Entry, FileSum, Manifest
from judge.problem.verdict import Verdict
from judge.sandbox.facts import RunLimits


def test_values_are_found_by_kind_and_key(tmp_path: Path) -> None:
    path = tmp_path / "new" / "store"
    many = {str(number): str(number * number) for number in range(2_000)}
    with Store(path) as store:
        store.put("square", many)
        store.put("square", {"3": "nine"})
        assert store.get("cube", ["3"]) == {}
    with Store(path) as store:
        assert store.get("square", [*many, "none"]) == many | {"3": "nine"}


@pytest.mark.parametrize("content", [b"no database at all" * 100, b"SQLite format 3\0" * 300])
def test_a_damaged_file_is_replaced(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "store"
    path.write_bytes(content)
    with Store(path) as store:
        store.put("a", {"b": "c"})
    with Store(path) as store:
        assert store.get("a", ["b"]) == {"b": "c"}


def test_where_no_file_can_be_written_values_stay_in_memory(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    for path in (tmp_path / "file" / "store", tmp_path):  # below a file; a directory
        with Store(path) as store:
            store.put("a", {"b": "c"})
            assert store.get("a", ["b"]) == {"b": "c"}
    assert [p.name for p in tmp_path.iterdir()] == ["file"]


def test_several_processes_write_at_once(tmp_path: Path) -> None:
    path = tmp_path / "store"
    code = (
        "import sys; from pathlib import Path; from judge.kit.store import Store\n"
        "store = Store(Path(sys.argv[1]))\n"
        "for n in range(50): store.put(sys.argv[2], {str(n): 'x'})\n"
    )
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    writers = [
        subprocess.Popen([sys.executable, "-c", code, str(path), kind], env=env) for kind in "abc"
    ]
    assert [writer.wait(timeout=60) for writer in writers] == [0, 0, 0]
    with sqlite3.connect(path) as connection:
        assert connection.execute("SELECT count(*) FROM kept").fetchone() == (150,)


def entry(sha256: str) -> Entry:
    file = FileSum(1, sha256)
    return Entry("f", {}, 1, 1, file, file, 1, 3, 0, 1, 0)


def test_a_verdict_is_kept_for_what_it_depends_on(tmp_path: Path) -> None:
    manifest = Manifest(1, {"a": entry("1"), "b": entry("2")})
    cases = [Case(name, "small", tmp_path, tmp_path) for name in ("a", "b", "not in it")]
    source = Submission("x.py", by_name("python"), b"print()")
    limits = RunLimits(5.0, 512, 8)
    with Store(tmp_path / "store") as store:
        kept = KeptVerdicts(store, source, limits, manifest)
        kept.keep({"a": Verdict.WA, "b": Verdict.JE, "not in it": Verdict.AC})
        assert kept.look_up(cases) == {"a": Verdict.WA}  # a judge error is not kept
        renamed = Submission("y.py", source.language, source.source)
        assert KeptVerdicts(store, renamed, limits, manifest).look_up(cases) == {"a": Verdict.WA}
        for other in (
            KeptVerdicts(store, Submission("x", source.language, b"pass"), limits, manifest),
            KeptVerdicts(store, Submission("x", by_name("pypy"), b"print()"), limits, manifest),
            KeptVerdicts(store, source, RunLimits(6.0, 512, 8), manifest),
            KeptVerdicts(store, source, limits, Manifest(1, {"a": entry("3")})),
        ):
            assert other.look_up(cases) == {}


def test_cases_alike_are_both_looked_up_and_a_damaged_verdict_is_not(tmp_path: Path) -> None:
    manifest = Manifest(1, {"a": entry("1"), "twin": entry("1"), "b": entry("2")})
    cases = [Case(name, "small", tmp_path, tmp_path) for name in manifest.cases]
    source = Submission("x.py", by_name("python"), b"print()")
    with Store(tmp_path / "store") as store:
        kept = KeptVerdicts(store, source, RunLimits(5.0, 512, 8), manifest)
        kept.keep({"a": Verdict.WA, "b": Verdict.AC})
        assert kept.look_up(cases) == {"a": Verdict.WA, "twin": Verdict.WA, "b": Verdict.AC}
        for row in store._connection.execute("SELECT key FROM kept").fetchall():
            store.put("verdict", {row[0]: "damaged"})
        assert kept.look_up(cases) == {}
