"""The command line of strength: what it refuses, before any work, and what it prints."""

import io

import msgspec
import pytest
from rich.console import Console

from judge.kit import files
from judge.kit.console import PlainConsole
from judge.problem.cases import Case
from judge.problem.declaration import load
from judge.problem.verdict import Verdict
from strength import cli
from strength.analysis import analyse
from strength.show import print_findings, print_groups
from strength.table import Matrix, Row


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("--jobs 0", "--jobs: expected a whole number of at least 1, found '0'"),
        ("mutants --jobs 0", "--jobs: expected a whole number of at least 1, found '0'"),
        ("mutants --quick -1", "--quick: expected a whole number of at least 1, found '-1'"),
        ("mutants --quick 0", "--quick: expected a whole number of at least 1, found '0'"),
        ("--json /nonexist/a", "strength: --json /nonexist/a: no such directory"),
        ("--html /nonexist/a", "strength: --html /nonexist/a: no such directory"),
        ("mutants --json /nonexist/a", "strength: --json /nonexist/a: no such directory"),
        ("--json /", "strength: --json /: expected a file, found a directory"),
        ("wrong_answer/always_yess.py", "did you mean 'wrong_answer/always_yes.py'?"),
        ("mutants brute.py", "brute.py: expected one of solution.py, "),
        ("mutants --data /nonexist", "strength: /nonexist: no such directory"),
    ],
)
def test_nonsense_is_refused_in_one_line_before_any_work(arguments, message, capsys):
    assert cli.main(arguments.split()) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert message in captured.err.splitlines()[-1]


def test_reports_go_to_build_even_if_it_is_not_there_yet(tmp_path, monkeypatch):
    monkeypatch.setattr(files, "BUILD", tmp_path / "build")
    place = tmp_path / "build" / "a.json"
    files.check_place("--json", place)
    assert not place.parent.exists()
    files.write_report("--json", place, lambda: b"{}\n")
    assert place.read_bytes() == b"{}\n"


def test_nothing_is_cut_where_no_terminal_is(monkeypatch):
    name = "wrong_answer/" + "long_" * 40 + "name.py"
    case = Case("secret/small/1", "small", *[None] * 2)
    matrix = Matrix((Row(name, {case.name: Verdict.WA}),), (case,), 1)
    problem = load()
    families = {case.name: "family_" * 20}
    monkeypatch.setitem(problem.submissions, name, {"small": "WA"})
    printed = io.StringIO()
    monkeypatch.setattr("sys.stdout", printed)
    analysis = analyse(matrix, problem, families)
    console = PlainConsole()
    assert isinstance(console, Console)
    print_groups(console, analysis)
    print_findings(console, matrix, analysis, needless=False)
    text = printed.getvalue()
    assert name in text
    assert families[case.name] in text
    assert "1 submission judged, all as declared" in text


def test_one_submission_on_the_samples(tmp_path, capsys):
    report = tmp_path / "report.json"
    arguments = ["wrong_answer/strict_touch.py", "--groups", "sample", "--json", str(report)]
    assert cli.main(arguments) == 0
    assert cli.main([*arguments, "--cases"]) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed[-1].startswith("1 submission, 4 cases: 0 runs made, the others kept")
    content = msgspec.json.decode(report.read_bytes())
    assert list(content["submissions"][0]["cases"].values()) == ["AC", "AC", "WA", "AC"]
