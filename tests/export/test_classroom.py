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
from gen.scenario import Scenario, parse
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


def scenarios(file: Path) -> list[Scenario]:
    return list(parse(file.read_bytes()))


@pytest.mark.parametrize("file", SAMPLES, ids=lambda path: path.stem)
def test_the_python_starter_reads_everything(
    file: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    read: list[Scenario] = []

    def free(robot: Any, move: Any, obstacles: Any) -> bool:
        read.append(Scenario(tuple(robot), move, tuple(map(tuple, obstacles))))
        return True

    assert starter.free([], (0, 0), [])
    monkeypatch.setattr(starter, "free", free)
    monkeypatch.setattr(sys, "stdin", file.open())
    starter.main()
    assert capsys.readouterr().out.split() == ["YES"] * len(scenarios(file))
    expected = [
        Scenario(tuple(s.robot), s.move, tuple(map(tuple, s.obstacles))) for s in scenarios(file)
    ]
    assert read == expected


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "file", "decides", "compiler", "command"),
    [
        (
            "starter.cpp",
            "a.cpp",
            "return (robot.size() + obstacles.size() + move.x + move.y) % 2 == 0;",
            ["g++", "-std=c++17", "-Wall", "-Werror", "a.cpp"],
            ["./a.out"],
        ),
        (
            "Starter.java",
            "Solution.java",
            "return (robot.x.length + obstacles.size() + dx + dy) % 2 == 0;",
            ["javac", "-Xlint", "-Werror", "Solution.java"],
            ["java", "Solution"],
        ),
    ],
    ids=["C++", "Java"],
)
def test_the_other_starters_read_everything(
    name: str, file: str, decides: str, compiler: list[str], command: list[str], tmp_path: Path
) -> None:
    """With an answer that depends on what was read."""
    if shutil.which(compiler[0]) is None:
        pytest.skip(f"no {compiler[0]} is installed")
    source = (TEMPLATE / name).read_text()
    assert source.count("return true;") == 1
    (tmp_path / file).write_text(source)
    subprocess.run(compiler, cwd=tmp_path, check=True)  # as it is, without a warning
    (tmp_path / file).write_text(source.replace("return true;", decides))
    subprocess.run(compiler, cwd=tmp_path, check=True)
    for given in [*SAMPLES, DATA / "secret/small/02-tiny.in"]:
        run = subprocess.run(
            command, cwd=tmp_path, stdin=given.open(), capture_output=True, text=True, check=True
        )
        assert run.stdout.split() == [
            "NO" if (len(s.robot) + len(s.obstacles) + sum(s.move)) % 2 else "YES"
            for s in scenarios(given)
        ]


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
