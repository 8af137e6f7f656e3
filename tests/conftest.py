"""Set-up for all tests: they can interrupt what they start."""

from __future__ import annotations

import os
import signal
import sys

import pytest
from xdist.remote import Producer
from xdist.scheduler import LoadScopeScheduling

from judge.kit.processors import processors

from .compiled import Compiled

# These tests run in one process, so that the browser starts, and programs are compiled, only once.
TOGETHER = ("tests/explorer/", "tests/stress/test_complete.py")


@pytest.hookimpl(tryfirst=True)
def pytest_configure() -> None:
    keep_bytecode()
    # A process started in the background (`make test &`, some CI runners) ignores SIGINT, and its
    # children inherit that. Tests interrupt their children and expect them to stop.
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture
def compiled_once(tmp_path_factory, monkeypatch):
    """In this test, submissions are compiled only if no test with this fixture did so before."""
    own = tmp_path_factory.getbasetemp()
    shared = (own.parent if "PYTEST_XDIST_WORKER" in os.environ else own) / "compiled"
    shared.mkdir(exist_ok=True)
    compiled = Compiled(shared)
    for module in ("judge.pool", "strength.gallery.programs"):
        monkeypatch.setattr(f"{module}.compile_submission", compiled.compile)


def keep_bytecode() -> None:
    """Let the hundreds of Python processes of the tests find compiled modules, as usual.

    Where PYTHONDONTWRITEBYTECODE is set, each of them would compile the kit and its libraries
    anew: a third of its CPU time.
    """
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    sys.dont_write_bytecode = False


class Together(LoadScopeScheduling):
    """Any idle process gets the next test; but the tests of each part of TOGETHER stay together."""

    def _split_scope(self, nodeid: str) -> str:
        return next((part for part in TOGETHER if nodeid.startswith(part)), nodeid)


def pytest_xdist_make_scheduler(config: pytest.Config, log: Producer) -> Together:
    return Together(config, log)


def pytest_xdist_auto_num_workers() -> int:
    """Return how many tests run at once with `-n auto`: one more, as many tests mostly wait."""
    return processors() + 1
