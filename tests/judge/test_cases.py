"""Finding, choosing and checking test cases."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

import pytest

from judge.problem.cases import CasesError, check_built, find_cases, select
from judge.problem.declaration import load
from judge.problem.manifest import check_complete, check_sums, load_manifest

PROBLEM = load()


def test_groups_in_the_declared_order_then_foreign_ones(data: Path) -> None:
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
def test_half_a_pair(data: Path, ending: str) -> None:
    (data / f"secret/small/02.{ending}").unlink()
    with pytest.raises(CasesError, match=rf"secret/small/02\.{ending}: .* missing$"):
        find_cases(data, PROBLEM)


def test_a_missing_answer_of_the_kit_can_be_rebuilt(data: Path, monkeypatch) -> None:
    monkeypatch.setattr("judge.problem.cases.DATA", data)
    (data / "secret/small/02.ans").unlink()
    with pytest.raises(CasesError, match=r"02\.ans: .* missing; run 'make data'$"):
        find_cases(data, PROBLEM)


@pytest.mark.parametrize("blank", [b"", b" \n\t\r\n", b"\n" * 5000])
def test_an_answer_file_that_a_silent_program_would_match(data: Path, blank: bytes) -> None:
    (data / "secret/small/02.ans").write_bytes(blank)
    with pytest.raises(CasesError, match=r"02\.ans: expected answers, found an empty file"):
        find_cases(data, PROBLEM)
    (data / "secret/small/02.ans").write_bytes(blank + b"YES")
    assert len(find_cases(data, PROBLEM)) == 4


def test_an_answer_that_cannot_be_read(data: Path, monkeypatch) -> None:
    def refuse(*_arguments: object, **_options: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "open", refuse)
    with pytest.raises(CasesError, match=r"01\.ans: cannot be read: Permission denied"):
        find_cases(data, PROBLEM)


def test_no_cases(tmp_path: Path) -> None:
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


def test_groups_that_are_not_built(data: Path) -> None:
    cases = find_cases(data, PROBLEM)
    check_built(cases, ["sample", "small"], data)
    with pytest.raises(CasesError, match=r"secret/large: .* run 'make data'"):
        check_built(cases, ["small", "large"], data)
    with pytest.raises(CasesError, match=r"data/sample: .* run 'make data'"):
        check_built(cases[1:], ["sample"], data)


def write_manifest(data: Path) -> None:
    def sums(path: Path) -> dict[str, Any]:
        content = path.read_bytes()
        return {"bytes": len(content), "sha256": hashlib.sha256(content).hexdigest(), "more": 1}

    entries = {
        case.name: {"input": sums(case.input), "answer": sums(case.answer), "seed": 7}
        for case in find_cases(data, PROBLEM)
    }
    (data / "manifest.json").write_text(json.dumps({"version": 1, "cases": entries}))


@pytest.mark.parametrize("ending", ["in", "ans"])
def test_files_that_are_not_what_was_built(data: Path, ending: str) -> None:
    write_manifest(data)
    manifest, cases = load_manifest(data), find_cases(data, PROBLEM)
    check_sums(manifest, cases)
    path = data / f"secret/small/02.{ending}"
    whole = path.read_bytes()
    path.write_bytes(whole[:-1])
    with pytest.raises(CasesError, match=rf"02\.{ending}: expected 10 bytes, found 9.*'make data'"):
        check_sums(manifest, cases)
    path.write_bytes(whole[:-1] + b" ")
    with pytest.raises(CasesError, match=rf"02\.{ending}: expected SHA-256 .* run 'make data'"):
        check_sums(manifest, cases)


def test_a_case_of_the_manifest_that_is_not_there(data: Path) -> None:
    write_manifest(data)
    manifest = load_manifest(data)
    cases = [case for case in find_cases(data, PROBLEM) if case.name != "secret/small/02"]
    check_complete(manifest, cases, ["static"])
    with pytest.raises(CasesError, match=r"secret/small/02: .* not built yet; run 'make data'"):
        check_complete(manifest, cases, ["small"])


def test_a_broken_manifest(data: Path) -> None:
    (data / "manifest.json").write_text("{")
    with pytest.raises(CasesError, match=r"manifest\.json: not a manifest"):
        load_manifest(data)
