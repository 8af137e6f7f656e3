"""The judging of one program as a task: plain data in and out, for any executor.

`outcomes` is the seam: whatever gives a `concurrent.futures.Executor` can judge a class, the
processes of this machine or a cluster.
"""

from __future__ import annotations

from collections import Counter, deque
from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from contextlib import AbstractContextManager
from dataclasses import dataclass

from judge.batch.outcome import Outcome, judge_error, outcome_of
from judge.feedback import told
from judge.judging import Options, judge
from judge.kit.errors import KitError
from judge.languages.submission import Submission
from judge.problem.declaration import Problem

MOST_TRIES = 3  # of a task whose worker died
AHEAD = 2  # tasks for each worker that are under way or wait in the executor

Executors = Callable[[], AbstractContextManager[Executor]]


@dataclass(frozen=True, slots=True)
class Task:
    """One program to judge. options.jobs is 1: a worker judges one program, one run at a time."""

    submission: Submission
    problem: Problem
    options: Options


def judge_task(task: Task) -> Outcome:
    """Task: judge a program. Raises no KitError: that is its JE."""
    try:
        judging = judge(task.submission, task.problem, task.options)
    except KitError as error:
        return judge_error(str(error), task.problem.max_score)
    return outcome_of(told(judging, task.problem.feedback))


def outcomes(
    tasks: Sequence[Task],
    executors: Executors,
    workers: int,
    work: Callable[[Task], Outcome] = judge_task,
) -> Generator[tuple[int, Outcome], None, None]:
    """Yield the number and the outcome of each task, in the order in which they end.

    executors: makes an executor, and another one when that breaks. workers: how many tasks it
    carries out at once. A task whose worker died is tried again alone, so that it cannot take
    others with it; after MOST_TRIES its outcome is JE. Closing the iterator closes the executor.
    """
    waiting = deque(range(len(tasks)))
    tries: Counter[int] = Counter()

    def lost(number: int, error: Exception) -> Iterator[tuple[int, Outcome]]:
        tries[number] += 1
        if tries[number] < MOST_TRIES:
            waiting.appendleft(number)
        else:
            why = f"its worker failed {MOST_TRIES} times: {error}"
            yield number, judge_error(why, tasks[number].problem.max_score)

    while waiting:
        with executors() as executor:
            running: dict[Future[Outcome], int] = {}
            broken = False
            while running or (waiting and not broken):
                while waiting and not broken:
                    most = 1 if tries[waiting[0]] else AHEAD * workers
                    if len(running) >= most:
                        break
                    number = waiting.popleft()
                    try:
                        running[executor.submit(work, tasks[number])] = number
                    except RuntimeError as error:  # such as BrokenExecutor
                        broken = True
                        yield from lost(number, error)
                for future in wait(running, timeout=1, return_when=FIRST_COMPLETED).done:
                    number = running.pop(future)
                    try:
                        outcome = future.result()
                    except Exception as error:  # its worker died; or it is a fault of the judge
                        broken |= isinstance(error, BrokenExecutor)
                        yield from lost(number, error)
                    else:
                        yield number, outcome
