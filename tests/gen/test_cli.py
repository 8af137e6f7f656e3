"""The command line, and the data directory that it keeps."""

import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from gen import manifest
from gen.build import BuildError, build_case
from gen.cli import main
from gen.plan import PLANNED, Case, user_cases
from judge.kit.paths import DATA, ROOT

SMALL = sum(case.group == "small" for case in PLANNED)


@pytest.fixture
def data(tmp_path: Path) -> Path:
    """A copy of the committed part of the data: manifest, samples, small cases."""
    copy = tmp_path / "data"
    shutil.copytree(DATA, copy, ignore=shutil.ignore_patterns("large", "many", "invalid_input"))
    return copy


def gen(*arguments):
    return main([str(argument) for argument in arguments])


def test_the_committed_data_is_what_plan_and_manifest_say():
    entries = manifest.load(DATA).cases
    assert set(entries) == {case.path for case in (*PLANNED, *user_cases(DATA))}
    for path, entry in entries.items():
        if path.split("/")[-2] not in ("large", "many"):
            assert manifest.faults(DATA, path, entry) == []


def test_build_does_nothing_when_all_is_current(data, capsys):
    assert gen("build", "secret/small/*", "--data", data) == 0
    assert f"0 built, {SMALL} were current" in capsys.readouterr().out


def test_build_repairs_what_is_missing_or_differs(data):
    before = (data / "secret/small/02-tiny.in").read_bytes()
    (data / "secret/small/02-tiny.in").write_bytes(before[:-5])
    (data / "secret/small/03-tiny-quads.ans").unlink()
    assert gen("build", "secret/small/0*", "--data", data, "--jobs", "1") == 0
    assert (data / "secret/small/02-tiny.in").read_bytes() == before
    assert (data / "secret/small/03-tiny-quads.ans").exists()


def test_a_sum_that_differs_from_the_manifest_is_an_error_and_writes_nothing(data, capsys):
    path = "secret/small/02-tiny"
    text = (data / "manifest.json").read_text()
    sum_ = manifest.load(data).cases[path].input.sha256
    (data / "manifest.json").write_text(text.replace(sum_, "0" * 64))
    before = (data / f"{path}.in").read_bytes()
    assert gen("build", path, "--data", data) == 1
    assert f"{path}: differs from the manifest in input;" in capsys.readouterr().err
    assert (data / f"{path}.in").read_bytes() == before
    assert gen("build", path, "--data", data, "--update-manifest") == 0
    assert (data / "manifest.json").read_text() == text


def test_check_finds_every_kind_of_fault(data, capsys):
    (data / "secret/small/02-tiny.in").unlink()
    (data / "secret/small/03-tiny-quads.ans").write_text("YES\n")
    (data / "secret/static/stray.in").write_text("0\n")
    assert gen("check", "--data", data) == 1
    errors = capsys.readouterr().err
    assert "secret/small/02-tiny.in: missing" in errors
    assert "secret/small/03-tiny-quads.ans: expected " in errors
    assert "secret/static/stray.in: no case of the plan" in errors


def test_check_of_files(tmp_path, capsys):
    good, bad = ROOT / "data/sample/01-first.in", tmp_path / "bad.in"
    bad.write_text("1\n2 0\n")
    assert gen("check", good) == 0
    assert gen("check", good, bad) == 1
    assert capsys.readouterr().err == f"{bad}:2: m: expected 3..500000, found 2\n"
    assert gen("check", "--group", "static", good) == 1


def test_make_prints_a_valid_file(capfdbinary):
    assert gen("make", "contacts", "--seed", 7, "--set", "vertices=300", "reach=5") == 0
    once = capfdbinary.readouterr().out
    assert gen("make", "contacts", "--seed", 7, "--set", "vertices=300", "--set", "reach=5") == 0
    assert capfdbinary.readouterr().out == once
    assert once.count(b"\n") > 100


def test_list_shows_every_case(capsys):
    assert gen("list") == 0
    shown = capsys.readouterr().out
    assert all(name in shown for name in ("01-largest", "contacts", "hugging"))


def test_a_case_of_ones_own_is_validated_answered_and_kept(data, capsys):
    arguments = ("case", "contacts", "--seed", 5, "--set", "vertices=200", "--data", data)
    assert gen(*arguments, "--group", "small") == 0
    path = "secret/small/contacts-5"
    assert f"{path}: " in capsys.readouterr().out
    entry = manifest.load(data).cases[path]
    assert manifest.faults(data, path, entry) == []
    assert [case.path for case in user_cases(data)] == [path]
    # Later builds know it, and make it again, byte for byte.
    (data / f"{path}.in").unlink()
    assert gen("build", "secret/small/contacts-*", "--data", data) == 0
    assert manifest.faults(data, path, entry) == []
    assert gen(*arguments, "--group", "small") == 2
    assert "is there already" in capsys.readouterr().err
    # The promise of another group is not kept: nothing of it stays.
    before = (data / "manifest.json").read_bytes()
    assert gen(*arguments, "--group", "static") == 1
    assert "dx dy: expected 0 0 in this group" in capsys.readouterr().err
    assert (data / "manifest.json").read_bytes() == before
    assert not list((data / "secret/static").glob("contacts*"))


def test_a_disagreement_stops_the_build_and_keeps_the_input(data, tmp_path, monkeypatch):
    liar = tmp_path / "liar.py"
    liar.write_text("print('YES\\n' * int(input()), end='')")
    monkeypatch.setattr("gen.answers.BRUTE_FORCE", liar)
    monkeypatch.setattr("gen.build.ROOT", tmp_path)
    monkeypatch.setattr("gen.build.DISAGREEMENTS", tmp_path / "build")
    case = Case("small", "01-new", "tiny")
    with pytest.raises(BuildError, match=r"scenario \d+: solution.py says NO, liar.py says YES"):
        build_case(data, case, None)
    assert (tmp_path / "build" / "secret-small-01-new.in").exists()
    assert not (data / f"{case.path}.in").exists()


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
        build_case(data, Case("small", "01-new", "tiny"), None)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["make", "contcats"], "no family 'contcats'; did you mean 'contacts'?"),
        (["make", "contacts", "--set", "reach"], "--set: expected NAME=VALUE, found 'reach'"),
        (["make", "contacts", "--set", "reech=2"], "did you mean 'reach'?"),
        (["make", "xyzzy"], "no family 'xyzzy'; expected one of contacts, "),
        (["make", "contacts", "--set", "reach=1_0"], "expected an integer of 1..200000000, found"),
        (
            ["make", "contacts", "--set", "reach=1", "reach=2"],
            "expected reach once, found it again",
        ),
        (["case", "contacts", "--group", "small", "--seed", "1" * 63], "the seed is too long"),
        (["check", "--data", "nowhere"], "--data: expected a data directory, found nowhere"),
        (["build", "secret/none/*"], "no case matches 'secret/none/*'"),
        (["build", "--jobs", "0"], "--jobs: expected at least 1, found 0"),
        (["case", "contacts", "--group", "smal"], "no group 'smal'"),
        (["case", "contacts", "--group", "small", "--name", "../x"], "--name: expected"),
        (["check", "--group", "smal", "x"], "no group 'smal'"),
    ],
)
def test_usage_errors_are_one_line(arguments, message, capsys):
    assert gen(*arguments) == 2
    errors = capsys.readouterr().err
    assert message in errors
    assert errors.count("\n") == 1


@pytest.mark.parametrize("content", ["", "[]", '{"version": 1}', "\0"])
def test_a_broken_manifest_is_one_line(data, content, capsys):
    (data / "manifest.json").write_text(content)
    assert gen("check", "--data", data) == 2
    assert capsys.readouterr().err.count("\n") == 1


@pytest.mark.parametrize("content", ["case = 3", "[[case]]\nnam = 'x'", "nonsense", "x = 1"])
def test_a_broken_list_of_cases_is_one_line(data, content, capsys):
    (data / "cases.toml").write_text(content)
    assert gen("check", "--data", data) == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_an_interrupted_build_leaves_nothing_half_written(data):
    build = subprocess.Popen(
        [sys.executable, "-m", "gen", "build", "secret/large/02-tiny", "--data", str(data)],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    time.sleep(1.0)
    os.kill(build.pid, signal.SIGINT)
    _, errors = build.communicate(timeout=60)
    assert build.returncode == 130
    assert b"Traceback" not in errors
    assert [p for p in data.rglob("*") if p.is_file() and p.name.startswith(".")] == []
