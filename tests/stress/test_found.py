"""What becomes of a counterexample: the command prints it, --add puts it into the data."""

import subprocess
import sys

import pytest

from gen.scenario import Scenario, render
from judge.explanation import Diagnosis, FailedScene, MissedLesson
from judge.kit.paths import ROOT, SUBMISSIONS
from judge.kit.trusted import run_trusted
from judge.problem.verdict import Verdict
from stress import cli
from stress.illustrate import illustrated
from stress.running.trial import Trial
from stress.search import result
from stress.search.add import AddError, add_to_data, fitting_group

TRIANGLE = [(0, 0), (1, 0), (0, 1)]
MANY = [(x, x * x) for x in range(2_001)]


@pytest.fixture(autouse=True)
def _kept_elsewhere(tmp_path, monkeypatch):
    monkeypatch.setattr(result, "COUNTEREXAMPLES", tmp_path / "kept")


@pytest.fixture
def file(tmp_path):
    def write(*scenarios):
        path = tmp_path / "shrunk-012345.in"
        path.write_bytes(render(scenarios))
        return path

    return write


def test_the_command_prints_what_it_finds_and_exits_with_1(tmp_path, capsys):
    program = tmp_path / "my.py"
    program.write_bytes((SUBMISSIONS / "wrong_answer" / "standing_still_is_free.py").read_bytes())
    assert cli.main([str(program), "--seed", "7", "--no-wall"]) == 1
    printed = capsys.readouterr().out
    (kept,) = (tmp_path / "kept").glob("*.in")
    assert kept.read_text() in printed
    assert "expected NO, found YES" in printed
    assert "seed 7" in printed


def test_the_scene_of_a_lesson_is_drawn_and_kept(tmp_path):
    content = render([Scenario(TRIANGLE, (0, 0), [TRIANGLE])]).decode()
    scene = FailedScene("touch-1", content, "NO", "no answer")
    lessons = (MissedLesson("a", "A.", ("touch-1",), scene), MissedLesson("b", "B.", ()))
    told = illustrated(Diagnosis(lessons, None, "", 9, 1))
    assert told.lessons[1] == lessons[1]
    drawn = told.lessons[0].scene
    assert drawn.sentence.startswith("The robot stands exactly where obstacle 1 is")
    assert drawn.file == tmp_path / "kept" / "scene-touch-1.in"
    assert drawn.file.read_text() == content
    assert drawn.file.with_suffix(".svg").read_text() == drawn.picture
    assert "expected NO, found no answer" in drawn.picture
    assert "gallery scene touch-1" in drawn.picture


def test_a_scene_that_cannot_be_kept_is_shown_all_the_same(tmp_path):
    (tmp_path / "kept").write_text("no directory")
    content = render([Scenario(TRIANGLE, (0, 0), [])]).decode()
    lesson = MissedLesson("a", "A.", ("s",), FailedScene("s", content, "YES", "NO"))
    (told,) = illustrated(Diagnosis((lesson,), None, "", 9, 1)).lessons
    assert told.scene.file is None
    assert told.scene.sentence.startswith("There are no obstacles")


def test_the_command_tells_how_much_a_right_program_answered(tmp_path, capsys):
    program = tmp_path / "all"
    program.write_text("import sys\n")
    assert cli.main([str(SUBMISSIONS.parent / "solution.py"), "--seconds", "1"]) == 0
    assert "scenarios answered correctly (seed " in capsys.readouterr().out


def test_the_checker_explains_and_a_judging_without_that_does_not_load_the_search():
    program = SUBMISSIONS / "wrong_answer" / "strict_touch.py"
    arguments = ["--group", "sample", "--explain", "--seed", "3"]
    run = subprocess.run(
        [sys.executable, ROOT / "checker.py", program, *arguments],
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 1
    assert "a smallest input that it gets wrong (1 obstacle, 6 vertices):" in run.stdout
    assert "seed 3" in run.stdout
    shown = "print(*[name for name in sys.modules if name.startswith(('gen.', 'pictures.'))])"
    loads = f"import sys, stress.front; {shown}"
    assert run_trusted("python", (sys.executable, "-c", loads)).split() == []


def test_of_several_scenarios_sentence_and_picture_say_which():
    free, hit = Scenario(TRIANGLE, (0, 0), []), Scenario(TRIANGLE, (0, 0), [TRIANGLE])
    trial = Trial((free, hit), Verdict.WA, True, (1,), "YES")
    found = result.counterexample(trial, "YES", 0.1, ())
    assert found.sentence.startswith("Scenario 2 of 2: The robot")
    assert "scenario 2 of 2" in found.picture
    alone = result.counterexample(Trial((hit,), Verdict.WA, True, (0,), "YES"), "YES", 0.1, ())
    assert alone.sentence.startswith("The robot")


def test_a_compile_error_is_shown_with_its_lines(tmp_path, capsys):
    program = tmp_path / "ce.py"
    program.write_text("x = 1\nif x\n    y = 2\n")
    assert cli.main([str(program), "--no-wall"]) == 2
    said = capsys.readouterr().err
    assert "\n    if x\n" in said
    assert "SyntaxError" in said
    assert said.endswith(f"stress: {program}: does not compile\n")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("none.cpp", "none.cpp: no such file"),
        ("my.py --group small", "argument --group: expected --add, too"),
        ("my.py --seconds 0", "--seconds: expected 1 to 86400, found '0'"),
    ],
)
def test_nonsense_is_refused_in_one_line(arguments, message, capsys):
    assert cli.main(arguments.split()) == 2
    assert capsys.readouterr().err.endswith(f"{message}\n")


def test_a_counterexample_is_added_once_to_the_first_group_that_fits(file, tmp_path):
    data = tmp_path / "data"
    data.mkdir()
    found = file(Scenario(TRIANGLE, (0, 0), [TRIANGLE]))
    said = add_to_data(found, data=data)
    assert said == "added to the data: secret/static/shrunk-012345: 0 YES, 1 NO"
    assert (data / "secret/static/shrunk-012345.in").read_bytes() == found.read_bytes()
    assert (data / "secret/static/shrunk-012345.ans").read_text() == "NO\n"
    assert "secret/static/shrunk-012345" in (data / "manifest.json").read_text()
    again = add_to_data(found, data=data)
    assert again == "in the data already: secret/static/shrunk-012345"
    assert add_to_data(found, "small", data=data) == again


def test_which_group_fits(file):
    assert fitting_group(file(Scenario(TRIANGLE, (1, 0), []))) == "small"
    assert fitting_group(file(Scenario(MANY, (0, 0), [TRIANGLE]))) == "large"
    found = file(Scenario(TRIANGLE, (0, 0), []))
    found.write_text("1\n")
    with pytest.raises(AddError, match="expected an input that fits a group"):
        fitting_group(found)


def test_what_gen_refuses_is_not_added(file, tmp_path, capsys):
    found = file(Scenario(TRIANGLE, (1, 0), []))
    with pytest.raises(AddError, match="was not added to the group static"):
        add_to_data(found, "static", data=tmp_path)
    assert "expected 0 0 in this group" in capsys.readouterr().err


def test_a_counterexample_that_cannot_be_added_is_shown_all_the_same(tmp_path, capsys):
    program = tmp_path / "my.py"
    program.write_text("for _ in range(int(input())): print('YES')\n")
    arguments = [str(program), "--seed", "1", "--no-wall", "--add", "--group", "nowhere"]
    assert cli.main(arguments) == 1
    captured = capsys.readouterr()
    assert "expected NO, found YES" in captured.out
    assert "was not added to the group nowhere" in captured.out
    assert "no group 'nowhere'" in captured.err
