"""Runs the kit's wrong submissions on scenarios."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from judge.diagnosis.asking import Answers, ask
from judge.diagnosis.gallery import Gallery
from judge.diagnosis.shape import letters
from judge.kit.paths import SUBMISSIONS
from judge.languages.submission import Program, compile_submission, read_submission
from judge.problem.declaration import Problem
from judge.problem.verdict import Verdict
from judge.run import Attempt, declared_limits, run_input
from judge.sandbox.facts import RunLimits
from judge.sandbox.sandbox import Sandbox

FAULTY = ("wrong_answer/", "run_time_error/")  # folders of what may fail on a tiny scenario
BATCH_LIMIT_S = 60.0  # CPU seconds for a file of the pool


@dataclass(frozen=True, slots=True)
class Faulty:
    """A wrong submission (its path in submissions/), ready to run."""

    name: str
    program: Program
    sandbox: Sandbox
    limits: RunLimits

    def attempts(self, contents: Iterable[bytes], limits: RunLimits) -> Iterator[Attempt]:
        """Yield one run per input file."""
        return (run_input(self.sandbox, self.program, limits, content) for content in contents)

    def answers(self, contents: Sequence[bytes], scenarios: Sequence[int]) -> str | None:
        """Return the answers to input files, one letter each; None if a run is out of step."""
        given = ""
        limits = self.limits._replace(time_limit_s=BATCH_LIMIT_S)
        for attempt, expected in zip(self.attempts(contents, limits), scenarios, strict=True):
            found = letters(attempt.output)
            if attempt.judgement.verdict is not Verdict.AC or len(found) != expected:
                return None
            given += found
        return given

    def asked(self, gallery: Gallery) -> Answers:
        """Ask it for its answers to the gallery."""
        return ask(gallery, self.attempts, self.limits)


def faulty_submissions(problem: Problem) -> list[str]:
    """Return the paths of the wrong submissions, in the order of problem.toml."""
    return [name for name in problem.submissions if name.startswith(FAULTY)]


def each(
    names: Sequence[str],
    problem: Problem,
    sandbox: Sandbox,
    jobs: int,
    work: Callable[[Faulty], object],
) -> None:
    """Do some work with each submission, `jobs` at a time. Raises what the work raises."""
    limits = declared_limits(problem.limits)

    def one(name: str) -> None:
        submission = read_submission(SUBMISSIONS / name)
        program = compile_submission(submission, problem.limits, sandbox)
        work(Faulty(name, program, sandbox, limits))

    with ThreadPoolExecutor(jobs) as pool:
        for future in [pool.submit(one, name) for name in names]:
            future.result()
