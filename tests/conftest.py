"""What holds for all tests."""

from __future__ import annotations

import signal

import pytest


@pytest.hookimpl(tryfirst=True)
def pytest_configure() -> None:
    # What is started in the background (`make test &`, some CI runners) ignores SIGINT, and so
    # would all that the tests start, also where a test interrupts it to see it stop.
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
