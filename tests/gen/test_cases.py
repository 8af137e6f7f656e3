"""Test cases that users add and remove, as CONTRIBUTING.md tells them to."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from gen.added import load_added
from gen.plan import load_plan
from judge.kit.checksums import Checksums
from judge.kit.paths import ROOT
from judge.problem.manifest import file_faults, load_manifest

MINE = "secret/small/mine"
BY_HAND = """2
3 1
4 0
0 0
2 0
0 2
3
6 0
8 0
6 2
3 0
0 0
0 0
2 0
0 2
"""
FAMILY = '''"""Two triangles, far apart or one upon the other.

Attacks nothing; it is an example.
"""

from collections.abc import Iterator

from gen.families.registry import Scenarios, family
from gen.rng import Rng
from gen.scenario import Scenario


@family
def mine(rng: Rng, *, scenarios: Scenarios = 40) -> Iterator[Scenario]:
    """Triangles that meet or do not."""
    for number in range(scenarios):
        x = rng.between(100, 900) * (number % 2)
        triangle = [(0, 0), (9, 0), (0, 9)]
        yield Scenario(triangle, (0, 0), [[(x + a, b) for a, b in triangle]])
'''


def state(data: Path) -> dict[str, bytes]:
    return {str(p.relative_to(data)): p.read_bytes() for p in data.rglob("*") if p.is_file()}


def is_good(data: Path, name: str) -> bool:
    entry = load_manifest(data).cases[name]
    return file_faults(data, name, entry, Checksums()) == []


def unbuilt(errors: str) -> set[str]:
    """Return what the check complains of, but for the large files that a copy does not have."""
    lines = (line for line in errors.splitlines() if not line.endswith(": missing"))
    return set(lines)


def test_a_case_of_a_family_is_validated_answered_and_kept(gen, data, capsys):
    arguments = ("case", "contacts", "--seed", 5, "--set", "vertices=200", "--data", data)
    assert gen(*arguments, "--group", "small") == 0
    name = "secret/small/contacts-5"
    assert f"{name}: " in capsys.readouterr().out
    assert is_good(data, name)
    assert [recipe.case_name for recipe in load_added(data)] == [name]
    # Later builds know it, and make it again, byte for byte.
    (data / f"{name}.in").unlink()
    assert gen("build", f"{name}*", "--data", data) == 0
    assert is_good(data, name)
    # The check knows it as well.
    gen("check", "--data", data)
    assert unbuilt(capsys.readouterr().err) == set()
    assert gen(*arguments, "--group", "small") == 2
    assert "is there already" in capsys.readouterr().err
    # It breaks the promise of another group: nothing of it stays.
    kept = state(data)
    assert gen(*arguments, "--group", "static") == 1
    assert "dx dy: expected 0 0 in this group" in capsys.readouterr().err
    assert state(data) == kept


def test_a_case_written_by_hand_is_validated_answered_and_kept(gen, data, tmp_path, capsys):
    before = state(data)
    mine = tmp_path / "mine.in"
    mine.write_text(BY_HAND)
    assert gen("case", "--file", mine, "--group", "small", "--data", data) == 0
    assert f"{MINE}: 1 YES, 1 NO" in capsys.readouterr().out
    assert (data / f"{MINE}.in").read_text() == BY_HAND
    assert (data / f"{MINE}.ans").read_text() == "NO\nYES\n"
    entry = load_manifest(data).cases[MINE]
    assert (entry.family, entry.seed, entry.scenarios) == ("", 0, 2)
    assert gen("build", "secret/small/m*", "--verify", "--data", data) == 0
    gen("check", "--data", data)
    assert unbuilt(capsys.readouterr().err) == set()
    assert gen("case", "--file", mine, "--group", "small", "--data", data) == 2
    assert "choose another --name\n" in capsys.readouterr().err
    name = ("--name", "again", "--data", data)
    assert gen("case", "--file", mine, "--group", "small", *name) == 0
    assert f"secret/small/again: the same input as {MINE}\n" in capsys.readouterr().err
    for added in ("again", MINE):
        assert gen("remove", added, "--data", data) == 0
    assert state(data) == before


@pytest.mark.parametrize(
    ("content", "options", "status", "message"),
    [
        (BY_HAND[:-2], (), 1, "mine.in:15: robot, vertex 3: expected a line end"),
        (BY_HAND, ("--group", "static"), 1, "mine.in:3: dx dy: expected 0 0 in this group"),
        (BY_HAND, ("--name", "My case"), 2, "--name: expected 1 to 61 small letters"),
        (BY_HAND, ("--seed", "3"), 2, "expected --file alone"),
        (BY_HAND, ("--set", "n=3"), 2, "expected --file alone"),
        (None, (), 2, "mine.in: No such file"),
    ],
)
def test_a_case_written_by_hand_that_is_refused_leaves_nothing(
    gen, data, tmp_path, capsys, content, options, status, message
):
    mine = tmp_path / "mine.in"
    if content is not None:
        mine.write_text(content)
    before = state(data)
    arguments = ("case", "--file", mine, "--group", "small", "--data", data, *options)
    assert gen(*arguments) == status
    errors = capsys.readouterr().err
    assert message in errors
    assert errors.count("\n") == 1
    assert state(data) == before


def test_a_disagreement_on_a_case_written_by_hand_leaves_nothing(
    gen, data, tmp_path, monkeypatch, capsys
):
    liar = tmp_path / "liar.py"
    liar.write_text("print('YES\\n' * int(input()), end='')")
    monkeypatch.setattr("gen.answers.BRUTE_FORCE", liar)
    monkeypatch.setattr("gen.build.ROOT", tmp_path)
    monkeypatch.setattr("gen.build.DISAGREEMENTS", tmp_path / "build")
    (tmp_path / "mine.in").write_text(BY_HAND)
    before = state(data)
    assert gen("case", "--file", tmp_path / "mine.in", "--group", "small", "--data", data) == 1
    assert "solution.py says NO, liar.py says YES" in capsys.readouterr().err
    assert state(data) == before


def test_only_added_cases_are_removed(gen, data, capsys):
    before = state(data)
    assert gen("remove", "secret/small/04-contacts", "--data", data) == 2
    assert "04-contacts is a case of the plan: take it out of gen/plan.toml" in (
        capsys.readouterr().err
    )
    assert gen("remove", "nothing", "--data", data) == 2
    assert "no added case 'nothing'" in capsys.readouterr().err
    assert state(data) == before
    for group in ("small", "static"):
        arguments = ("--set", "move=zero", "--data", data, "--group", group, "--name", "same")
        assert gen("case", "cuts", *arguments) == 0
    assert gen("remove", "same", "--data", data) == 2
    assert "several added cases: secret/small/same, secret/static/same" in capsys.readouterr().err
    assert gen("remove", "static/same", "--data", data) == 0
    assert gen("remove", "sam", "--data", data) == 2
    assert "did you mean 'same'?" in capsys.readouterr().err
    assert gen("remove", "same", "--data", data) == 0
    assert state(data) == before


def test_one_sided_answers_are_said_when_a_case_is_added(gen, data, capsys):
    arguments = ("--group", "large", "--data", data)
    assert gen("case", "hugging", "--set", "deciding=none", "scenarios=12", *arguments) == 0
    warnings = capsys.readouterr().err
    assert "hugging-1: 100 % of 12 answers are YES (expected 30 to 70 %)" in warnings
    assert "always says YES" in warnings
    assert gen("case", "contacts", "--seed", 5, *arguments) == 0
    assert capsys.readouterr().err == ""


def test_one_sided_answers_are_said_when_a_family_is_tried(gen, capfd):
    assert gen("make", "hugging", "--set", "deciding=any", "scenarios=12") == 0
    assert "family hugging: 0 % of 12 answers are YES" in capfd.readouterr().err


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"case = 3", "cases.toml: case: Expected `array`, got `int`"),
        (
            b"[[case]]\nnam = 'x'",
            "cases.toml: case 1: unknown key 'nam'; did you mean 'name'?",
        ),
        (b"[[case]]\nname = 'x'", "case 1: Object missing required field `group`"),
        (b"nonsense", "cases.toml: not valid TOML: "),
        (b"x = 1", "cases.toml: unknown key 'x'; expected one of case"),
        (b"# \xff", "cases.toml: not UTF-8 text (byte 2)"),
        (b"[[case]]\ngroup = 'smal'\nname = 'x'", "no group 'smal'; did you mean 'small'?"),
        (b"[[case]]\ngroup = 'small'\nname = '../x'", "name: expected 1 to 61 small letters"),
        (b"[[case]]\ngroup = 'small'\nname = '02-tiny'", "is a case of the plan"),
        (b"[[case]]\ngroup = 'small'\nname = 'x'\n" * 2, "stands in the list twice"),
        (
            b"[[case]]\ngroup = 'small'\nname = 'x'\nfamily = 'contcats'",
            "no family 'contcats'; did you mean 'contacts'?",
        ),
        (
            b"[[case]]\ngroup = 'small'\nname = 'x'\nfamily = 'cuts'\nparameters = {reech = 3}",
            "no parameter 'reech'; did you mean 'reach'?",
        ),
    ],
)
def test_a_broken_list_of_cases_is_one_line(gen, data, content, message, capsys):
    (data / "cases.toml").write_bytes(content)
    assert gen("check", "--data", data) == 2
    errors = capsys.readouterr().err
    assert message in errors
    assert errors.count("\n") == 1


@pytest.fixture
def kit(tmp_path: Path) -> Path:
    """A copy of the kit, with no more data than is committed."""
    copy = tmp_path / "kit"
    ignored = shutil.ignore_patterns("large", "many", "__pycache__")
    for folder in ("gen", "judge", "data", "submissions/accepted", "tests/gen"):
        shutil.copytree(ROOT / folder, copy / folder, ignore=ignored)
    for file in (".gitignore", "problem.toml", "pyproject.toml", "solution.py", "brute.py"):
        shutil.copy(ROOT / file, copy / file)
    for file in ("tests/conftest.py", "tests/compiled.py"):
        shutil.copy(ROOT / file, copy / file)
    return copy


def in_kit(kit: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", *arguments]
    return subprocess.run(command, cwd=kit, capture_output=True, text=True, check=False)


def test_a_family_is_found_wherever_its_file_lies(kit):
    (kit / "gen/families/mine.py").write_text(FAMILY)
    (kit / "gen/families/size/other.py").write_text(FAMILY.replace("def mine", "def other"))
    made = in_kit(kit, "gen", "make", "mine")
    assert (made.returncode, made.stderr) == (0, "")
    assert made.stdout.startswith("40\n3 1\n0 0\n")
    assert " other " in in_kit(kit, "gen", "list").stdout
    added = in_kit(kit, "gen", "case", "mine", "--group", "small")
    assert added.stdout == "secret/small/mine-1: 20 YES, 20 NO\n"
    (kit / "gen/families/touching/mine.py").write_text(FAMILY)
    assert "family mine: defined in " in in_kit(kit, "gen", "list").stderr


@pytest.mark.slow
def test_all_that_contributing_tells_leaves_the_tests_green(kit):
    (kit / "gen/families/mine.py").write_text(FAMILY)
    (kit / "mine.in").write_text(BY_HAND)
    plan = kit / "gen/plan.toml"
    plan.write_text(plan.read_text().replace("01-first = {}", "01-first = {}\n", 1))
    text = plan.read_text()
    at = text.index("# Sizes at the limits")
    plan.write_text(text[:at] + '58-mine = { family = "mine" }\n' + text[at:])
    for command in (
        ("build", "secret/small/*", "--update-manifest"),
        ("case", "contacts", "--seed", "7", "--group", "small"),
        ("case", "contacts", "--group", "small"),  # the same input as a planned case
        ("case", "--file", "mine.in", "--group", "small"),
        ("case", "hugging", "--set", "deciding=none", "--group", "static", "--set", "far=0"),
        ("case", "mine", "--group", "static"),
    ):
        done = in_kit(kit, "gen", *command)
        assert done.returncode == 0, done.stderr
    tests = in_kit(kit, "pytest", "tests/gen", "-m", "not slow", "-q", "-p", "no:cacheprovider")
    assert tests.returncode == 0, tests.stdout[-3000:]


def test_clean_deletes_only_what_a_build_makes_again(gen, data, tmp_path, capsys):
    large = data / "secret" / "large"
    large.mkdir()
    own = tmp_path / "mine.in"
    own.write_text(BY_HAND)
    assert gen("case", "--file", own, "--group", "large", "--data", data) == 0
    assert gen("case", "contacts", "--set", "scenarios=2", "--group", "large", "--data", data) == 0
    planned = next(r for r in load_plan() if r.group == "large" and r.family)
    for path in (large / f"{planned.name}.in", large / "notes.txt", data / "secret/many/x.in"):
        path.parent.mkdir(exist_ok=True)
        path.write_text("something")
    small = sorted((data / "secret" / "small").iterdir())
    capsys.readouterr()
    assert gen("clean", "--data", data) == 0
    kept = ["mine.ans", "mine.in", "notes.txt"]
    assert sorted(path.name for path in large.iterdir()) == kept
    assert (data / "secret/many/x.in").exists()
    assert sorted((data / "secret" / "small").iterdir()) == small
    said = capsys.readouterr().out
    assert said.startswith("3 files deleted, which `gen build` makes again\n")
    assert all(f"kept: {large / name} (no build makes it)\n" in said for name in kept)
