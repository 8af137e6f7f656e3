"""Every command ends with one line and an exit status, even if its streams fail."""

from __future__ import annotations

import subprocess
import sys

import pytest

from judge.kit.command import Parser, run
from judge.kit.paths import ROOT

COMMANDS = {
    "gen": "-m gen make contacts",
    "pictures": "-m pictures show data/sample/01-first.in 1",
    "strength": "-m strength mutants --light --quick 1",
    "stress": "-m stress random --seeds 1 --scenarios 10",
}


def shell(line: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["/bin/sh", "-c", line],
        **{"cwd": ROOT, "stdin": subprocess.DEVNULL, "capture_output": True, "text": True},
        check=False,
        timeout=120,
    )


@pytest.mark.parametrize(
    "name",
    [pytest.param(n, marks=[pytest.mark.slow] if n == "strength" else []) for n in COMMANDS],
)
@pytest.mark.parametrize(
    ("to", "message"),
    [
        (">/dev/full", "standard output: No space left on device"),
        (">&-", "standard output is closed"),
    ],
)
def test_output_that_cannot_be_written(name: str, to: str, message: str) -> None:
    done = shell(f"{sys.executable} {COMMANDS[name]} {to}")
    assert done.returncode == 2
    # An erased progress bar may leave an empty line before it.
    assert done.stderr.lstrip("\n") == f"{name}: {message}\n"


@pytest.mark.parametrize("name", COMMANDS)
def test_all_streams_closed(name: str) -> None:
    assert shell(f"{sys.executable} {COMMANDS[name]} <&- >&- 2>&-").returncode == 2


def test_nothing_is_said_when_the_reader_goes_away() -> None:
    done = shell(f"(sleep 0.5; {sys.executable} {COMMANDS['gen']}; echo $? >&2) | true")
    assert done.stderr == "1\n"


def test_a_validator_without_input() -> None:
    done = shell(f"{sys.executable} gen/validator.py <&-")
    assert (done.returncode, done.stderr) == (2, "standard input: is closed\n")


@pytest.mark.parametrize(
    ("error", "status", "line"),
    [
        (KeyboardInterrupt(), 130, "x: interrupted\n"),
        (ValueError("bad"), 2, "x: bad\n"),
        (FileNotFoundError(2, "No such file", "/a"), 2, "x: /a: No such file\n"),
    ],
)
def test_how_a_command_ends(
    capsys: pytest.CaptureFixture[str], error: BaseException, status: int, line: str
) -> None:
    def command() -> int:
        raise error

    assert run("x", command, (ValueError,)) == status
    assert capsys.readouterr().err == line


def test_an_unforeseen_exception_is_not_hidden() -> None:
    def command() -> int:
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        run("x", command, (ValueError,))


@pytest.mark.parametrize(
    ("line", "near"),
    [
        ("checker.py a.py --exlpain", "--explain"),
        ("-m gen build --forse=1", "--force"),
        ("-m pictures show a.in 1 --outputs x.svg", "--output"),
        ("-m strength mutants --quikc 1", "--quick"),
        ("-m stress table --sede 1", "--seed"),
        ("-m stress my.py --sede 1", "--seed"),
        ("-m bench growth --rums 1", "--runs"),
    ],
)
def test_a_mistyped_option_is_met_with_the_nearest(line: str, near: str) -> None:
    done = shell(f"{sys.executable} {line}")
    assert done.returncode == 2
    assert "unrecognized arguments: -" in done.stderr
    assert done.stderr.endswith(f"; did you mean '{near}'?\n")


def test_what_is_like_no_option_gets_no_suggestion(capsys: pytest.CaptureFixture[str]) -> None:
    parser = Parser(prog="x")
    parser.add_argument("--force")
    for word in ("force", "--zzz"):
        with pytest.raises(SystemExit):
            parser.parse_args([word])
        assert capsys.readouterr().err.endswith(f"unrecognized arguments: {word}\n")


def test_every_command_line_is_parsed_in_one_place() -> None:
    own = {"judge/kit/command.py", "gen/validator.py"}  # the validator stands alone
    packages = (
        "judge",
        "gen",
        "stress",
        "strength",
        "bench",
        "pictures",
        "explorer",
        "tools",
        "export",
        "autograder",
    )
    found = {
        path.relative_to(ROOT).as_posix()
        for package in packages
        for path in (ROOT / package).rglob("*.py")
        if "argparse.ArgumentParser(" in path.read_text()
    }
    assert found <= own
