"""Worker processes of this machine, each of which judges one program at a time.

A worker ends when its owner closes the executor or dies, whatever the owner dies of: it holds
the reading end of a pipe whose writing end only the owner has. The run that it is in the middle
of ends with it, and its scratch files are removed.
"""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context
from multiprocessing.connection import Connection, wait
from typing import ParamSpec, TypeVar

from judge.batch.outcome import Outcome
from judge.batch.tasks import Task, judge_task

P = ParamSpec("P")
T = TypeVar("T")
CLEAN_UP_S = 20.0


class _Stopped(BaseException):
    """The owner is gone or wants to end."""


class _Workers(ProcessPoolExecutor):
    """Processes that are started with SIGINT blocked: Ctrl-C is for their owner alone."""

    def submit(self, fn: Callable[P, T], /, *args: P.args, **kwargs: P.kwargs) -> Future[T]:
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            return super().submit(fn, *args, **kwargs)
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def local_workers(jobs: int) -> Iterator[Executor]:
    """Yield an executor of `jobs` processes; if the block fails, they are stopped at once."""
    context = get_context("spawn")  # a fork would copy the threads' locks
    reader, writer = context.Pipe(duplex=False)
    executor = _Workers(jobs, mp_context=context, initializer=_begin, initargs=(reader,))
    try:
        yield executor
    except BaseException:
        writer.close()
        raise
    finally:
        executor.shutdown(cancel_futures=True)
        writer.close()
        reader.close()


def judge_here(task: Task) -> Outcome:
    """Task: judge a program in a worker of `local_workers`."""
    _BUSY.set()
    try:
        return judge_task(task)
    except _Stopped:
        os._exit(0)  # nothing of the judging is left, and nobody waits for the outcome
    finally:
        _BUSY.clear()


_BUSY = threading.Event()  # a task is under way in this process


def _begin(owner: Connection) -> None:
    """Prepare a worker process."""
    signal.signal(signal.SIGINT, lambda *_: None)  # unlike SIG_IGN, programs do not inherit it
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    signal.signal(signal.SIGTERM, _stop)
    threading.Thread(target=_end_with, args=(owner,), daemon=True).start()


def _stop(*_: object) -> None:
    if _BUSY.is_set():
        raise _Stopped
    os._exit(0)


def _end_with(owner: Connection) -> None:
    """End this process when the pipe's other end is closed."""
    wait([owner])
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(CLEAN_UP_S)
    os._exit(1)
