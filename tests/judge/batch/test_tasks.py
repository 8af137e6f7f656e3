"""The seam: any executor carries out the tasks; a worker that dies loses nothing."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from judge.batch.outcome import Outcome
from judge.batch.tasks import MOST_TRIES, Task, outcomes
from judge.batch.workers import local_workers
from judge.judging import Options
from judge.languages.submission import Submission
from judge.languages.table import by_name
from judge.problem.declaration import load
from judge.problem.verdict import Verdict

PROBLEM = load()
SECONDS = {"nap": 0.3, "sleep": 60}


def tasks_of(sources: list[str]) -> list[Task]:
    python = by_name("python")
    return [Task(Submission("", python, text.encode()), PROBLEM, Options()) for text in sources]


def pretend(task: Task) -> Outcome:
    """Do what the "program" says instead of judging it."""
    word, _, path = task.submission.source.decode().partition(" ")
    if word == "die" or (word == "die-once" and not Path(path).exists()):
        if path:
            Path(path).touch()
        os._exit(3)
    if word == "fail":
        raise ValueError("a fault of the judge")
    if word in SECONDS:
        time.sleep(SECONDS[word])
    return Outcome(Verdict.AC, 100, 100, [], 0.0, failure=word)


@contextmanager
def threads() -> Iterator[Executor]:
    with ThreadPoolExecutor(2) as executor:
        yield executor


def test_threads_carry_out_the_tasks_as_well() -> None:
    tasks = tasks_of([str(number) for number in range(20)])
    found = dict(outcomes(tasks, threads, 2, pretend))
    assert {number: outcome.failure for number, outcome in found.items()} == {
        number: str(number) for number in range(20)
    }


def test_a_fault_of_the_judge_is_a_judge_error_of_one_task() -> None:
    found = dict(outcomes(tasks_of(["a", "fail", "b"]), threads, 2, pretend))
    assert [found[n].verdict for n in range(3)] == [Verdict.AC, Verdict.JE, Verdict.AC]
    assert "a fault of the judge" in found[1].failure


def test_an_executor_that_takes_nothing_ends_with_judge_errors() -> None:
    class Broken(Executor):
        def submit(self, *_: Any, **__: Any) -> Any:
            raise RuntimeError("it is broken")

    @contextmanager
    def broken() -> Iterator[Executor]:
        yield Broken()

    found = dict(outcomes(tasks_of(["a", "b"]), broken, 2, pretend))
    assert {outcome.failure for outcome in found.values()} == {
        f"its worker failed {MOST_TRIES} times: it is broken"
    }


@pytest.mark.slow
def test_a_worker_that_dies_loses_no_other_task(tmp_path: Path) -> None:
    sources = ["a", "nap", "die", "nap", "nap", f"die-once {tmp_path / 'died'}", "d"]
    found = dict(outcomes(tasks_of(sources), partial(local_workers, 2), 2, pretend))
    verdicts = [found[number].verdict for number in range(len(sources))]
    assert verdicts == [Verdict.JE if text == "die" else Verdict.AC for text in sources]


def test_closing_ends_the_workers_in_the_middle_of_a_task() -> None:
    running = outcomes(tasks_of(["a", "sleep"]), partial(local_workers, 1), 1, pretend)
    assert next(running)[0] == 0
    before = time.monotonic()
    running.close()
    assert time.monotonic() - before < 20
