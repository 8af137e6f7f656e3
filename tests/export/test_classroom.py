"""The template repository for students, its workflow, and the workflow of the kit itself."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

from export.classroom import starter
from export.files import Files
from export.package import Package
from export.targets.classroom import TARGETS, TEMPLATE
from export.verify.classroom import pushed
from export.verify.job import VerifyError
from export.verify.workflow import run_job, skipped, steps_of
from judge.kit.paths import BRUTE_FORCE, DATA, REFERENCE, ROOT, SUBMISSIONS
from judge.problem.declaration import load

(TARGET,) = TARGETS
KIT_WORKFLOW = ROOT / ".github/workflows/ci.yml"
STUDENT_WORKFLOW = TEMPLATE / "judge.yml"
SAMPLES = sorted((DATA / "sample").glob("*.in"))


@pytest.fixture(scope="module")
def files(telling: Package) -> Files:
    return TARGET.build(telling)


def test_nothing_gives_the_solution_away(files: Files) -> None:
    own = {path.read_bytes() for path in SUBMISSIONS.rglob("*.*")}
    own |= {REFERENCE.read_bytes(), BRUTE_FORCE.read_bytes()}
    assert [name for name, entry in files if entry.read() in own] == []
    rooms = {name.split("/")[1] for name in files.entries if name.startswith("kit/")}
    folders = {room for room in rooms if "." not in room}
    assert folders == {"LICENSE", "data", "gen", "judge", "tools"}
    assert b"stress" not in files.entries["kit/checker.py"].read().split(b'"""')[2]


def test_students_are_told_lessons_and_no_counterexample(files: Files, tmp_path: Path) -> None:
    problem = tmp_path / "problem.toml"
    problem.write_bytes(files.entries["kit/problem.toml"].read())
    assert load(problem).feedback.tell == "lessons"
    assert load(problem).groups == load().groups


def test_what_the_documents_show_is_there(files: Files) -> None:
    for document in ("README.md", "problem.md"):
        text = files.entries[document].read().decode()
        for place in re.findall(r"\]\(([^)#:]+)\)", text):
            assert place in files.entries
        for place in re.findall(r"(?:starters|kit)/[\w./]*\w", text):
            assert place in files.entries


def test_rebuilt_inputs_are_ignored_by_git(files: Files) -> None:
    ignored = files.entries[".gitignore"].read().decode().splitlines()
    answers = {name[:-4] for name in files.entries if name.endswith(".ans")}
    inputs = {name[:-3] for name in files.entries if name.endswith(".in")}
    assert {f"/{name}.in" for name in answers - inputs} <= set(ignored)
    assert not {f"/{name}.in" for name in inputs} & set(ignored)


@pytest.mark.parametrize("workflow", [KIT_WORKFLOW, STUDENT_WORKFLOW])
def test_a_workflow_is_as_safe_as_it_can_be(workflow: Path) -> None:
    content: dict[Any, Any] = yaml.safe_load(workflow.read_text())
    assert content["permissions"] == {"contents": "read"}
    assert "push" in content[True]  # YAML 1.1 reads `on` so
    for job in content["jobs"].values():
        assert job["timeout-minutes"]
        for step in job["steps"]:
            if "uses" in step:
                assert re.fullmatch(r"actions/[a-z-]+@v\d+", step["uses"])
            if step.get("uses", "").startswith("actions/checkout"):
                assert step["with"]["persist-credentials"] is False


def test_the_kits_workflow_runs_what_contributors_run() -> None:
    runs = [step["run"] for step in steps_of(KIT_WORKFLOW, "ci") if not skipped(step)]
    assert runs == ["bash .ci/run"]
    assert (ROOT / ".ci/run").is_file()


def test_only_what_changes_the_machine_is_skipped() -> None:
    steps = steps_of(STUDENT_WORKFLOW, "judge")
    ran = [step["name"] for step in steps if not skipped(step)]
    assert ran == ["Find the program", "Set up the judge", "Judge", "Tell the verdict"]


def test_steps_run_as_a_runner_runs_them(tmp_path: Path) -> None:
    workflow, place = tmp_path / "w.yml", tmp_path / "place"
    place.mkdir()
    steps = [
        {"name": "uses", "uses": "actions/checkout@v6"},
        {
            "name": "fails",
            "run": "echo one >> $GITHUB_STEP_SUMMARY\nfalse | tee out\necho two > two",
        },
        {"name": "late", "run": "touch late"},
        {"name": "always", "if": "always()", "run": "echo three >> $GITHUB_STEP_SUMMARY"},
    ]
    workflow.write_text(yaml.safe_dump({"jobs": {"j": {"steps": steps}}}))
    ran = run_job(workflow, "j", place)
    assert (ran.failed, ran.summary) == ("fails", "one\nthree\n")
    assert [path.name for path in place.iterdir()] == ["out"]
    with pytest.raises(VerifyError, match="'other'"):
        run_job(workflow, "other", place)


def answers(command: list[str], file: Path) -> list[str]:
    done = subprocess.run(command, stdin=file.open(), capture_output=True, text=True, check=True)
    return done.stdout.split()


def always_yes(file: Path) -> list[str]:
    return ["YES"] * len(file.with_suffix(".ans").read_text().split())


@pytest.mark.parametrize("file", SAMPLES, ids=lambda path: path.stem)
def test_the_python_starter_reads_everything(file: Path) -> None:
    assert answers([sys.executable, starter.__file__], file) == always_yes(file)


@pytest.mark.slow
def test_the_other_starters_read_everything(tmp_path: Path) -> None:
    if not (shutil.which("g++") and shutil.which("javac")):
        pytest.skip("no g++ or no javac is installed")
    shutil.copyfile(TEMPLATE / "Starter.java", tmp_path / "Solution.java")
    compilers = (
        ["g++", "-std=c++17", "-Wall", "-Werror", "-o", "a.out", TEMPLATE / "starter.cpp"],
        ["javac", "-Xlint", "-Werror", "Solution.java"],
    )
    for compiler in compilers:
        subprocess.run(compiler, cwd=tmp_path, check=True)
    for command in (["./a.out"], ["java", "Solution"]):
        for file in [*SAMPLES, *sorted((DATA / "secret/small").glob("0*.in"))]:
            run = subprocess.run(
                command, cwd=tmp_path, stdin=file.open(), capture_output=True, text=True, check=True
            )
            assert run.stdout.split() == always_yes(file)


@pytest.mark.slow
def test_the_workflow_judges_what_is_pushed(files: Files, tmp_path: Path) -> None:
    """With a few cases of each group; `verify` does the same with all of them."""
    repository = tmp_path / "repository"
    files.write_directory(repository)
    pushed(repository, {}, "", "found 0")
    starters = repository / "starters"
    pushed(repository, {"solution.py": starters / "solution.py"}, "WA  0 of 100 points", "what it")
    both = {"solution.py": REFERENCE, "Solution.java": starters / "Solution.java"}
    pushed(repository, both, "", "found 2: ")
    pushed(repository, {"solution.py": REFERENCE}, "AC  100 of 100 points", "many")
