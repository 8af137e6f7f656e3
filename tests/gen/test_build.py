"""The build and the check: files, checksums and the manifest that describes them."""

import hashlib
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from gen import build
from gen.added import all_recipes
from gen.answers import recorded_answers
from gen.build import BuildError, build_case
from gen.cli import main
from gen.plan import Recipe, load_plan
from judge.kit.checksums import Checksums
from judge.kit.paths import DATA, ROOT
from judge.kit.store import Store
from judge.problem.cases import group_of
from judge.problem.manifest import file_faults, load_manifest, sum_of

TINY = "secret/small/02-tiny"
SMALL = [recipe.case_name for recipe in load_plan() if recipe.group == "small"]


def faults(data, name, entry):
    return file_faults(data, name, entry, Checksums())


def recipe_of(name):
    return next(recipe for recipe in load_plan() if recipe.case_name == name)


def test_the_data_is_what_plan_added_cases_and_manifest_say():
    entries = load_manifest(DATA).cases
    assert list(entries) == [recipe.case_name for recipe in all_recipes()]
    for name, entry in entries.items():
        if group_of(name) not in ("large", "many"):  # those are not committed
            assert faults(DATA, name, entry) == []


def test_build_does_nothing_when_all_is_current(gen, data, capsys):
    assert gen("build", "secret/small/*", "--data", data) == 0
    assert f"0 built, {len(SMALL)} were current" in capsys.readouterr().out


def test_build_repairs_what_is_missing_or_differs(gen, data):
    before = (data / f"{TINY}.in").read_bytes()
    (data / f"{TINY}.in").write_bytes(before[:-5])
    (data / "secret/small/03-tiny-quads.ans").unlink()
    assert gen("build", "secret/small/0*", "--data", data, "--jobs", "1") == 0
    assert (data / f"{TINY}.in").read_bytes() == before
    assert (data / "secret/small/03-tiny-quads.ans").exists()


@pytest.mark.parametrize("field", ["input", "answer"])
def test_a_checksum_that_differs_from_the_manifest_is_an_error(gen, data, capsys, field):
    text = (data / "manifest.json").read_text()
    sum_ = getattr(load_manifest(data).cases[TINY], field).sha256
    (data / "manifest.json").write_text(text.replace(sum_, "0" * 64))
    before = (data / f"{TINY}.in").read_bytes()
    assert gen("build", TINY, "--data", data) == 1
    assert f"{TINY}: differs from the manifest in {field};" in capsys.readouterr().err
    assert (data / f"{TINY}.in").read_bytes() == before
    assert gen("build", TINY, "--data", data, "--update-manifest") == 0
    assert (data / "manifest.json").read_text() == text


def calls(monkeypatch, name):
    """Count the calls of a function that the build uses."""
    called = []
    function = getattr(build, name)

    def counting(*arguments):
        called.append(name)
        return function(*arguments)

    monkeypatch.setattr(build, name, counting)
    return called


def test_only_what_is_new_or_to_be_verified_needs_validator_and_second_method(data, monkeypatch):
    expected = load_manifest(data).cases[TINY]
    validated, agreed = calls(monkeypatch, "validate"), calls(monkeypatch, "agreed")
    assert build_case(data, recipe_of(TINY), expected, verify=False) == expected
    assert (validated, agreed) == ([], [])
    for entry, verify in ((expected, True), (None, False)):
        validated.clear()
        agreed.clear()
        assert build_case(data, recipe_of(TINY), entry, verify=verify) == expected
        assert (validated, agreed) == (["validate"], ["agreed"])


def test_verify_makes_what_is_current_again(gen, data, capsys):
    assert gen("build", TINY, "--verify", "--data", data) == 0
    assert "1 built, 0 were current" in capsys.readouterr().out


def test_what_was_built_is_not_read_again_for_its_checksums(gen, data, tmp_path, monkeypatch):
    """Its checksums are kept once its time stamps have settled, see judge.kit.checksums."""
    monkeypatch.setattr("gen.commands.build.Store", lambda: Store(tmp_path / "store.sqlite"))
    monkeypatch.setattr("judge.kit.checksums.SETTLED_AFTER_NS", 0)
    time.sleep(0.02)
    assert gen("build", "secret/small/0*", "--force", "--data", data) == 0
    entry = load_manifest(data).cases[TINY]
    with Store(tmp_path / "store.sqlite") as store:
        monkeypatch.setattr(hashlib, "file_digest", None)
        assert file_faults(data, TINY, entry, Checksums(store)) == []


def test_answers_are_found_by_their_checksum_when_few_come_into_question():
    entries = load_manifest(DATA).cases.values()
    found = [(entry, recorded_answers(entry)) for entry in entries]
    assert all(sum_of(answers) == entry.answer for entry, answers in found if answers is not None)
    few = [answers for entry, answers in found if min(entry.yes, entry.no) == 0]
    assert None not in few
    assert len([answers for _, answers in found if answers is None]) >= 50


def test_answers_that_are_there_need_no_reference(gen, data, monkeypatch):
    """As in a kit for students, which has none."""
    (data / f"{TINY}.in").unlink()
    (data / f"{TINY}.ans").rename(data / f"{TINY}.kept")
    monkeypatch.setattr(build, "REFERENCE", data / "none.py")
    monkeypatch.setattr(build, "recorded_answers", lambda _entry: None)
    assert gen("build", TINY, "--data", data, "--jobs", "1") == 1
    (data / f"{TINY}.kept").rename(data / f"{TINY}.ans")
    assert gen("build", TINY, "--data", data, "--jobs", "1") == 0
    assert faults(data, TINY, load_manifest(data).cases[TINY]) == []


def test_check_finds_every_kind_of_fault(gen, data, capsys):
    (data / f"{TINY}.in").unlink()
    (data / "secret/small/03-tiny-quads.ans").write_text("YES\n")
    (data / "secret/small/04-contacts.in").write_text("1\n2 0\n")
    (data / "secret/static/stray.in").write_text("0\n")
    text = (data / "manifest.json").read_text()
    entry = load_manifest(data).cases["secret/small/05-contacts-start"]
    text = text.replace(str(entry.seed), str(entry.seed + 1)).replace(
        f'"vertices": {entry.vertices},\n   "pair_sum": {entry.pair_sum}',
        f'"vertices": 77,\n   "pair_sum": {entry.pair_sum}',
    )
    (data / "manifest.json").write_text(text)
    assert gen("check", "--data", data) == 1
    errors = capsys.readouterr().err
    assert f"{TINY}.in: missing" in errors
    assert "secret/small/03-tiny-quads.ans: expected " in errors
    assert "secret/small/04-contacts.in:2: m: expected 3..2000, found 2" in errors
    assert "05-contacts-start.in: vertices: the manifest says 77, found" in errors
    assert "05-contacts-start: the manifest says otherwise in seed" in errors
    assert "secret/static/stray.in: no case of the plan" in errors


def test_check_of_files(gen, tmp_path, capsys):
    good, bad = ROOT / "data/sample/01-first.in", tmp_path / "bad.in"
    bad.write_text("1\n2 0\n")
    assert gen("check", good) == 0
    assert gen("check", good, bad) == 1
    assert capsys.readouterr().err == f"{bad}:2: m: expected 3..500000, found 2\n"
    assert gen("check", "--group", "static", good) == 1


def test_a_disagreement_stops_the_build_and_keeps_the_input(data, tmp_path, monkeypatch):
    liar = tmp_path / "liar.py"
    liar.write_text("print('YES\\n' * int(input()), end='')")
    monkeypatch.setattr("gen.answers.BRUTE_FORCE", liar)
    monkeypatch.setattr("gen.build.ROOT", tmp_path)
    monkeypatch.setattr("gen.build.DISAGREEMENTS", tmp_path / "build")
    recipe = Recipe("small", "01-new", "tiny")
    with pytest.raises(BuildError, match=r"scenario \d+: solution.py says NO, liar.py says YES"):
        build_case(data, recipe, None, verify=False)
    assert (tmp_path / "build" / "secret-small-01-new.in").exists()
    assert not (data / f"{recipe.case_name}.in").exists()


@pytest.mark.parametrize(
    ("program", "message"),
    [
        ("import sys; sys.exit('broken')", "exit status 1: broken"),
        ("print('MAYBE')", "expected"),
        ("", "expected"),
    ],
)
def test_a_method_that_fails_is_reported(data, tmp_path, monkeypatch, program, message):
    (tmp_path / "method.py").write_text(program)
    monkeypatch.setattr("gen.answers.REFERENCE", tmp_path / "method.py")
    with pytest.raises(BuildError, match=f"secret/small/01-new: method.py: {message}"):
        build_case(data, Recipe("small", "01-new", "tiny"), None, verify=False)


def test_an_interrupted_build_leaves_nothing_half_written(data):
    build = subprocess.Popen(
        [sys.executable, "-m", "gen", "build", "secret/large/02-tiny", "--data", str(data)],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    children = Path(f"/proc/{build.pid}/task/{build.pid}/children")
    while not children.read_text():  # until there are workers
        time.sleep(0.02)
    time.sleep(0.2)
    os.kill(build.pid, signal.SIGINT)
    _, errors = build.communicate(timeout=60)
    assert build.returncode == 130
    assert b"Traceback" not in errors
    assert [p for p in data.rglob("*") if p.is_file() and p.name.startswith(".")] == []


@pytest.mark.parametrize("content", [b"", b"[]", b'{"version": 1}', b"\0", b'{"version": "\xff"}'])
def test_a_broken_manifest_is_one_line(gen, data, content, capsys):
    (data / "manifest.json").write_bytes(content)
    for command in ("check", "build"):
        assert gen(command, "--data", data) == 2
        errors = capsys.readouterr().err
        assert errors.startswith(f"gen: {data}/manifest.json: not a manifest: ")
        assert errors.count("\n") == 1


def test_the_help_ends_well_when_nobody_reads_it(capsys):
    assert main(["--help"]) == 0
    assert "build" in capsys.readouterr().out
