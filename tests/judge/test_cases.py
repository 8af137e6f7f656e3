"""Finding, choosing and checking test cases."""

from __future__ import annotations

import hashlib
import os
from pathlib import Path

import pytest

from judge.kit.checksums import Checksums
from judge.kit.store import Store
from judge.problem.cases import CasesError, find_cases, select
from judge.problem.data import check_complete, check_unchanged, load_data
from judge.problem.declaration import load
from judge.problem.manifest import (
    Entry,
    Manifest,
    ManifestError,
    load_manifest,
    save_manifest,
    sum_of,
)
from judge.problem.order import OrderError, judging_order, save_order

PROBLEM = load()


def test_declared_groups_come_first_in_their_order(data: Path) -> None:
    for name in ("zoo/1", "loose", "invalid_input/bad"):
        path = data / name
        path.parent.mkdir(exist_ok=True)
        path.with_suffix(".in").touch()
        path.with_suffix(".ans").write_text("YES\n")
    cases = find_cases(data, PROBLEM)
    assert [(c.group, c.name) for c in cases] == [
        ("sample", "sample/01"),
        ("static", "secret/static/01"),
        ("small", "secret/small/01"),
        ("small", "secret/small/02"),
        (".", "loose"),
        ("zoo", "zoo/1"),
    ]


@pytest.mark.parametrize("ending", ["in", "ans"])
def test_half_a_pair_is_an_error(data: Path, ending: str) -> None:
    (data / f"secret/small/02.{ending}").unlink()
    with pytest.raises(CasesError, match=rf"secret/small/02\.{ending}: .* missing$"):
        find_cases(data, PROBLEM)


def test_a_missing_answer_of_the_kit_can_be_rebuilt(data: Path, monkeypatch) -> None:
    monkeypatch.setattr("judge.problem.cases.DATA", data)
    (data / "secret/small/02.ans").unlink()
    with pytest.raises(CasesError, match=r"02\.ans: .* missing; run 'make data'$"):
        find_cases(data, PROBLEM)


@pytest.mark.parametrize("blank", [b"", b" \n\t\r\n", b"\n" * 5000])
def test_a_blank_answer_file_is_an_error(data: Path, blank: bytes) -> None:
    (data / "secret/small/02.ans").write_bytes(blank)
    with pytest.raises(CasesError, match=r"02\.ans: expected answers, found an empty file"):
        find_cases(data, PROBLEM)
    (data / "secret/small/02.ans").write_bytes(blank + b"YES")
    assert len(find_cases(data, PROBLEM)) == 4


def test_an_unreadable_answer_file_is_an_error(data: Path, monkeypatch) -> None:
    def refuse(*_arguments: object, **_options: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "open", refuse)
    with pytest.raises(CasesError, match=r"01\.ans: cannot be read: Permission denied"):
        find_cases(data, PROBLEM)


def test_a_directory_without_cases_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(CasesError, match=r"expected pairs .* found none"):
        find_cases(tmp_path, PROBLEM)
    with pytest.raises(CasesError, match=r"none: no such directory"):
        find_cases(tmp_path / "none", PROBLEM)
    (tmp_path / "file").touch()
    with pytest.raises(CasesError, match=r"file: not a directory"):
        find_cases(tmp_path / "file", PROBLEM)


def test_selection(data: Path) -> None:
    cases = find_cases(data, PROBLEM)

    def chosen(groups: list[str], globs: list[str]) -> list[str]:
        return [case.name for case in select(cases, groups, globs)]

    assert chosen([], []) == [case.name for case in cases]
    assert chosen(["small", "sample"], []) == ["sample/01", "secret/small/01", "secret/small/02"]
    assert chosen(["small"], ["01"]) == ["secret/small/01"]
    assert chosen([], ["small/*", "sample/*"]) == [
        "sample/01",
        "secret/small/01",
        "secret/small/02",
    ]
    with pytest.raises(CasesError, match="no group 'smal'; did you mean 'small'"):
        chosen(["smal"], [])
    looks = r"no test case matches '9\*' \(they look like 'secret/static/01'\)"
    with pytest.raises(CasesError, match=looks):
        chosen(["static", "small"], ["9*"])


def test_a_group_that_is_not_built_is_an_error(data: Path) -> None:
    cases = find_cases(data, PROBLEM)
    nothing = Manifest(1, {})
    check_complete(nothing, cases, ["sample", "small"], data)
    with pytest.raises(CasesError, match=r"secret/large: .* run 'make data'"):
        check_complete(nothing, cases, ["small", "large"], data)
    with pytest.raises(CasesError, match=r"data/sample: .* run 'make data'"):
        check_complete(nothing, cases[1:], ["sample"], data)


def write_manifest(data: Path) -> None:
    made = {"family": "", "parameters": {}, "repeat": 1, "seed": 0}
    holds = {"scenarios": 1, "vertices": 3, "pair_sum": 0, "yes": 1, "no": 0}
    entries = {
        case.name: Entry(
            **made,  # type: ignore[arg-type] # fields by name
            **holds,
            input=sum_of(case.input.read_bytes()),
            answer=sum_of(case.answer.read_bytes()),
        )
        for case in find_cases(data, PROBLEM)
    }
    save_manifest(data, entries)


@pytest.mark.parametrize("ending", ["in", "ans"])
def test_a_file_that_differs_from_the_manifest_is_an_error(
    data: Path, tmp_path: Path, ending: str
) -> None:
    write_manifest(data)
    with Store(tmp_path / "store") as store:
        assert len(load_data(PROBLEM, data, store=store).chosen) == 4
        path = data / f"secret/small/02.{ending}"
        whole = path.read_bytes()
        path.write_bytes(whole[:-1])
        cut = rf"02\.{ending}: expected 10 bytes, found 9.*'make data'"
        with pytest.raises(CasesError, match=cut):
            load_data(PROBLEM, data, store=store)
        path.write_bytes(whole[:-1] + b" ")
        changed = rf"02\.{ending}: expected SHA-256 .* run 'make data'"
        with pytest.raises(CasesError, match=changed):
            load_data(PROBLEM, data, store=store)


def test_an_unchanged_file_is_read_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "file"
    path.write_bytes(b"one")
    monkeypatch.setattr("judge.kit.checksums.SETTLED_AFTER_NS", -1)
    with Store(tmp_path / "store") as store:
        first = Checksums(store)
        one = first.sha256(path)
        first.keep()
        assert Checksums(store).sha256(path) == one == hashlib.sha256(b"one").hexdigest()
        store.put("sha256", {str(path): store.get("sha256", [str(path)])[str(path)][:-1] + "?"})
        assert Checksums(store).sha256(path).endswith("?"), "it was read again"
        before = path.stat()
        path.write_bytes(b"two")  # same length, and the old time stamp restored
        os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
        assert Checksums(store).sha256(path) == hashlib.sha256(b"two").hexdigest()


def test_the_checksum_of_a_file_just_written_is_not_kept(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_bytes(b"one")
    with Store(tmp_path / "store") as store:
        checksums = Checksums(store)
        checksums.sha256(path)
        checksums.keep()
        assert store.get("sha256", [str(path)]) == {}


def test_a_missing_case_of_the_manifest_is_an_error(data: Path) -> None:
    write_manifest(data)
    manifest = load_manifest(data)
    cases = [case for case in find_cases(data, PROBLEM) if case.name != "secret/small/02"]
    check_complete(manifest, cases, ["static"], data)
    with pytest.raises(CasesError, match=r"secret/small/02: .* not built yet; run 'make data'"):
        check_complete(manifest, cases, ["small"], data)
    check_unchanged(manifest, cases, data, Checksums())


@pytest.mark.parametrize("content", [b"{", b'{"version": 1}', b'{"cases": "\xff"}', b"\xff"])
def test_a_broken_manifest_is_an_error(data: Path, content: bytes) -> None:
    (data / "manifest.json").write_bytes(content)
    with pytest.raises(ManifestError, match=r"manifest\.json: not a manifest"):
        load_manifest(data)


def test_the_order_of_judging(data: Path) -> None:
    """Cases that order.json names come first; strange names are skipped; groups stay."""
    for ending in (".in", ".ans"):
        (data / f"secret/small/03{ending}").write_text("NO\n")
    cases = find_cases(data, PROBLEM)
    by_name = [case.name for case in cases]
    assert [case.name for case in judging_order(data, cases)] == by_name
    save_order(data, ["secret/small/03", "secret/gone/01", "secret/small/02", "sample/01"])
    assert [case.name for case in judging_order(data, cases)] == [
        *("sample/01", "secret/static/01"),
        *("secret/small/03", "secret/small/02", "secret/small/01"),
    ]
    (data / "order.json").write_text('{"version": 1, "case": []}')
    with pytest.raises(OrderError, match=r"order\.json: not an order of cases"):
        judging_order(data, cases)
