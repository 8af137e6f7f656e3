"""The programs that are compared, made ready to run."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from judge.kit.errors import KitError
from judge.kit.paths import BRUTE_FORCE, REFERENCE, SUBMISSIONS
from judge.kit.trusted import python_command
from judge.languages.submission import CompileError, compile_submission, read_submission
from judge.problem.declaration import load
from judge.sandbox.sandbox import Sandbox
from stress.compare import Program

PYTHON = (REFERENCE, BRUTE_FORCE, SUBMISSIONS / "accepted" / "textbook.py")
CPP = (
    SUBMISSIONS / "accepted" / "textbook.cpp",
    SUBMISSIONS / "accepted" / "chord_across_edge.cpp",
    SUBMISSIONS / "time_limit_exceeded" / "brute_force.cpp",
)


class NotReadyError(KitError):
    """A program to compare does not compile."""


def ready(paths: Iterable[Path], sandbox: Sandbox, every: int = 1) -> list[Program]:
    """Return the programs, compiled where their language asks for it.

    What is compiled is gone with the sandbox. Raises NotReadyError, SubmissionError,
    LanguageError without a compiler, SandboxError.
    """
    return [Program(path.name, _command(path, sandbox), every) for path in paths]


def _command(path: Path, sandbox: Sandbox) -> tuple[str, ...]:
    submission = read_submission(path)
    if submission.language.name == "Python 3":  # the kit's own interpreter, started faster
        return python_command(path)
    try:
        return compile_submission(submission, load().limits, sandbox).command.argv
    except CompileError as error:
        raise NotReadyError(f"{path}: does not compile: {error}") from None
