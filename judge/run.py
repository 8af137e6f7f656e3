"""Runs a compiled submission on one test case and judges the run."""

from __future__ import annotations

from judge.compare import compare
from judge.decide import decide
from judge.languages.submission import Program
from judge.problem.cases import Case
from judge.problem.verdict import Verdict
from judge.results import CaseResult
from judge.sandbox.facts import RunLimits
from judge.sandbox.sandbox import Sandbox, SandboxError


def run_case(sandbox: Sandbox, program: Program, limits: RunLimits, case: Case) -> CaseResult:
    """Run a program on one test case and judge it. A fault of the machine is JE."""
    try:
        directory = sandbox.new_directory("output-")
        output = directory / "stdout"
        try:
            facts = sandbox.run(program.command, limits, stdin=case.input, stdout=output)
            with output.open("rb") as found, case.answer.open("rb") as expected:
                mismatch = compare(found, expected)
        finally:
            output.unlink(missing_ok=True)
            if directory.is_dir():
                directory.rmdir()
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
    )
