"""Runs a compiled submission: on one test case, which is judged, or on any input."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from judge.compare import compare
from judge.decide import Judgement, decide
from judge.languages.submission import Program
from judge.problem.cases import Case
from judge.problem.declaration import Limits
from judge.problem.verdict import Verdict
from judge.results import CaseResult
from judge.sandbox.facts import Facts, RunLimits
from judge.sandbox.sandbox import Sandbox, SandboxError


@dataclass(frozen=True, slots=True)
class Attempt:
    """A run on an input that is no test case. judgement: AC means only that it ended well."""

    facts: Facts
    output: bytes
    judgement: Judgement


# Runs a program on the texts of input files, and yields the runs in order.
Attempts = Callable[[Iterable[bytes], RunLimits], Iterator[Attempt]]


def declared_limits(limits: Limits, time_limit_s: float | None = None) -> RunLimits:
    """Return the declared limits of a run; time_limit_s: instead of the declared one."""
    return RunLimits(time_limit_s or limits.time_limit_s, limits.memory_mib, limits.output_mib)


def run_input(sandbox: Sandbox, program: Program, limits: RunLimits, content: bytes) -> Attempt:
    """Run a program on the text of an input file and return its output. Raises SandboxError."""
    try:
        with _scratch(sandbox, "stdin") as given, _scratch(sandbox, "stdout") as output:
            given.write_bytes(content)
            facts = sandbox.run(program.command, limits, stdin=given, stdout=output)
            found = output.read_bytes()
    except OSError as error:
        raise SandboxError(f"{error.filename or 'a file'}: {error.strerror}") from None
    judgement = decide(facts, limits, None, program.reason(facts.stderr))
    return Attempt(facts, found[: limits.output_bytes], judgement)


@contextmanager
def _scratch(sandbox: Sandbox, name: str) -> Iterator[Path]:
    """Yield the path of a scratch file in a directory of its own; remove both afterwards."""
    directory = sandbox.new_directory("output-" if name == "stdout" else "input-")
    file = directory / name
    try:
        yield file
    finally:
        file.unlink(missing_ok=True)
        if directory.is_dir():
            directory.rmdir()


def run_case(sandbox: Sandbox, program: Program, limits: RunLimits, case: Case) -> CaseResult:
    """Run a program on one test case and judge it. A fault of the machine is JE."""
    try:
        with _scratch(sandbox, "stdout") as output:
            facts = sandbox.run(program.command, limits, stdin=case.input, stdout=output)
            with output.open("rb") as found, case.answer.open("rb") as expected:
                mismatch = compare(found, expected)
    except SandboxError as error:
        return CaseResult(case, Verdict.JE, 0.0, 0.0, 0.0, str(error))
    except OSError as error:
        why = f"{error.filename or 'a file'}: {error.strerror}"
        return CaseResult(case, Verdict.JE, 0.0, 0.0, 0.0, why)
    judgement = decide(facts, limits, mismatch, program.reason(facts.stderr))
    return CaseResult(
        case,
        judgement.verdict,
        round(facts.cpu_s, 4),
        round(facts.elapsed_s, 4),
        round(facts.memory_mib, 2),
        judgement.message,
        mismatch=mismatch if judgement.verdict is Verdict.WA else None,
        stderr="" if judgement.verdict is Verdict.AC else program.shown(facts.stderr),
    )
