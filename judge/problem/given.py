"""Checks of test cases that a user gives, before anything runs; and their missing answers.

Only files that look like inputs of this problem are checked: `--data` takes other pairs, too.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Iterator, Sequence
from pathlib import Path

from judge.kit.files import write_whole
from judge.kit.paths import DATA, REFERENCE, VALIDATOR
from judge.kit.text import counted, printable
from judge.kit.trusted import ANSWERS, python_command, read_answers, run_to_end, run_trusted
from judge.problem.cases import Case, CasesError, input_files

_LINE_BYTES = 64  # more than any line of a valid input has
_FILES_AT_ONCE = 1000  # a command line is limited


def check_given(cases: Sequence[Case]) -> None:
    """Raise CasesError for the first fault of a case: a malformed input, answers that do not fit.

    The stand-alone validator reads all inputs in one run. O(size of the files).
    """
    own = [case for case in cases if _is_input(case.input)]
    _validate([case.input for case in own])
    for case in own:
        _check_answers(case)


def make_answers(directory: Path) -> Iterator[Path]:
    """Let the reference write each missing answer file, whole or not at all; yield its path.

    All these inputs are validated first. Raises CasesError, ProgramError, OSError.
    """
    if directory == DATA:
        raise CasesError(f"{directory}: the kit's own answers are built by 'make data'")
    missing = [
        path for path in input_files(directory) if not os.path.lexists(path.with_suffix(".ans"))
    ]
    _validate(missing)
    for path in missing:
        content = path.read_bytes()
        output = run_trusted(REFERENCE.name, python_command(REFERENCE), content)
        answers = read_answers(REFERENCE.name, output, _scenarios(content))
        write_whole(path.with_suffix(".ans"), "".join(f"{each}\n" for each in answers).encode())
        yield path.with_suffix(".ans")


def wrong_answer_in(case: Case, scenario: int) -> str:
    """Return a sentence if the answer file disagrees with the reference in a scenario, else "".

    Raises ProgramError, OSError.
    """
    if not _is_input(case.input):
        return ""
    content = case.input.read_bytes()
    output = run_trusted(REFERENCE.name, python_command(REFERENCE), content)
    right = read_answers(REFERENCE.name, output, _scenarios(content))[scenario - 1]
    given = case.answer.read_text(encoding="ascii").split()[scenario - 1].upper()
    if given == right:
        return ""
    return f"{case.answer}: scenario {scenario}: the file says {given}, the reference says {right}"


def _is_input(path: Path) -> bool:
    """Tell whether a file begins as an input of this problem: `t`, then `m k`."""
    with contextlib.suppress(OSError, ValueError), path.open("rb") as file:
        found = [list(map(int, file.readline(_LINE_BYTES).split())) for _ in range(2)]
        return [len(line) for line in found] == [1, 2]
    return False


def _validate(paths: Sequence[Path]) -> None:
    """Raise CasesError for the first malformed input."""
    for start in range(0, len(paths), _FILES_AT_ONCE):
        some = paths[start : start + _FILES_AT_ONCE]
        command = [*python_command(VALIDATOR), *map(str, some)]
        done = run_to_end(VALIDATOR.name, command)
        if done.returncode:
            said = os.fsdecode(done.stderr).strip().rpartition("\n")[2]
            raise CasesError(said or f"{VALIDATOR.name}: exit status {done.returncode}")


def _check_answers(case: Case) -> None:
    """Raise CasesError unless there is one answer, YES or NO, for each scenario."""
    try:
        with case.input.open("rb") as file:
            scenarios = _scenarios(file.readline(_LINE_BYTES))
        lines = case.answer.read_bytes().splitlines()
    except OSError as error:
        raise CasesError(f"{error.filename}: cannot be read: {error.strerror}") from None
    for number, line in enumerate(lines, 1):
        for word in line.split():
            if word.decode("latin-1").upper() not in ANSWERS:
                where = f"{case.answer}:{number}"
                raise CasesError(f"{where}: expected YES or NO, found {printable(word)!r}")
    found = sum(len(line.split()) for line in lines)
    if found != scenarios:
        raise CasesError(
            f"{case.answer}: expected {counted(scenarios, 'answer')}, "
            f"as {case.input.name} says, found {found:,}"
        )


def _scenarios(content: bytes) -> int:
    """Return `t` of a valid input."""
    return int(content[:_LINE_BYTES].partition(b"\n")[0])
