"""Runs the program on files of scenarios and says which answers are wrong."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from gen.scenario import Scenario, render
from judge.kit.text import printable
from judge.problem.verdict import Verdict
from judge.run import Attempt, Attempts
from judge.sandbox.facts import RunLimits
from stress.running.reference import answers

File = Sequence[Scenario]

NAMES = {
    Verdict.RTE: "crash",
    Verdict.TLE: "time limit exceeded",
    Verdict.MLE: "memory limit exceeded",
    Verdict.OLE: "output limit exceeded",
}


@dataclass(frozen=True, slots=True)
class Trial:
    """What became of one file.

    verdict: AC, WA, or how the run failed. in_step: it printed one word per scenario. wrong: the
    indices of the wrong answers, if it is in step. found: the first wrong answer, or in words
    what it printed, or how it ended.
    """

    scenarios: tuple[Scenario, ...]
    verdict: Verdict
    in_step: bool
    wrong: tuple[int, ...]
    found: str

    @property
    def index(self) -> int:
        """Of the first scenario that is answered wrongly; of the last if it is not in step."""
        return self.wrong[0] if self.wrong else len(self.scenarios) - 1

    @property
    def failed(self) -> bool:
        """Whether anything is wrong."""
        return self.verdict is not Verdict.AC


class Subject:
    """The program under search: runs of it, all behind its wall.

    attempts: runs it on texts of input files, in order, several at once. limits: those of each
    run. runs, vertices: how many there were so far, and how many were in their files. answered:
    how many scenarios it has answered correctly.
    """

    def __init__(self, attempts: Attempts, limits: RunLimits) -> None:
        self._attempts = attempts
        self.limits = limits
        self.runs = self.vertices = self.answered = 0

    def limited(self, limits: RunLimits) -> Subject:
        """Return the same program under other limits."""
        return Subject(self._attempts, limits)

    def trials(self, files: Iterable[File]) -> Iterator[Trial]:
        """Yield the trial of each file, in order; the next files run meanwhile."""
        given: deque[tuple[Scenario, ...]] = deque()

        def contents() -> Iterator[bytes]:
            for file in files:
                given.append(tuple(file))
                yield render(file)

        for attempt in self._attempts(contents(), self.limits):
            scenarios = given.popleft()
            self.runs += 1
            self.vertices += sum(scenario.vertices for scenario in scenarios)
            trial = _trial(attempt, scenarios)
            if not trial.failed:
                self.answered += len(trial.scenarios)
            yield trial

    def trial(self, file: File) -> Trial:
        """Return the trial of one file."""
        (trial,) = self.trials([file])
        return trial

    def first_failure(self, files: Iterable[File], verdict: Verdict | None = None) -> Trial | None:
        """Return the trial of the first file that fails, if given with this verdict.

        The files after it are not run, but for a few that run at the same time.
        """
        for trial in self.trials(files):
            if trial.failed and verdict in (None, trial.verdict):
                return trial
        return None


def shortest_failing_prefix(subject: Subject, file: File) -> Trial | None:
    """Return the trial of the shortest part, from the beginning of a failing file, that fails.

    By bisection, so O(log n) runs; it is the shortest if every part longer than a failing one
    fails as well. None: nothing fails any more, so the program's answers change.
    """
    passes, best = 0, subject.trial(file)
    while best.failed and len(best.scenarios) - passes > 1:
        middle = best.wrong[0] + 1 if best.wrong else (passes + len(best.scenarios)) // 2
        if middle == len(best.scenarios):
            break
        trial = subject.trial(best.scenarios[:middle])
        if trial.failed:
            best = trial
        elif best.wrong:  # what was wrong before is right now
            return None
        else:
            passes = middle
    return best if best.failed else None


def _trial(attempt: Attempt, scenarios: tuple[Scenario, ...]) -> Trial:
    verdict = attempt.judgement.verdict
    if verdict is not Verdict.AC:
        found = f"{NAMES.get(verdict, str(verdict))}: {attempt.judgement.message}"
        return Trial(scenarios, verdict, False, (), found)
    words = attempt.output.split()
    if len(words) != len(scenarios):
        return Trial(scenarios, Verdict.WA, False, (), _out_of_step(words, len(scenarios)))
    right = " ".join(answers(scenarios)).lower().encode().split()
    pairs = zip(attempt.output.lower().split(), right, strict=True)
    wrong = tuple(index for index, (word, answer) in enumerate(pairs) if word != answer)
    verdict = Verdict.WA if wrong else Verdict.AC
    found = printable(words[wrong[0]]) if wrong else ""
    return Trial(scenarios, verdict, True, wrong, found)


def _out_of_step(words: list[bytes], scenarios: int) -> str:
    """Return in words what a program printed that printed too little or too much."""
    if not words:
        return "nothing" if scenarios == 1 else f"nothing at all for {scenarios} scenarios"
    shown = printable(b" ".join(words[-4:]))
    many = "1 word" if len(words) == 1 else f"{len(words)} words"
    wanted = "1 scenario" if scenarios == 1 else f"{scenarios} scenarios"
    return f"{many} for {wanted}, at the end {shown}"
