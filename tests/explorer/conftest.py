"""The built page in a headless Chromium: the one of the system, driven by Playwright."""

from __future__ import annotations

import json
import shutil

import pytest

from explorer.cli import PAGE


@pytest.fixture(scope="session")
def browser():
    chromium = shutil.which("chromium")
    if chromium is None:
        pytest.skip("Chromium is not installed; on Debian: apt-get install chromium")
    playwright = pytest.importorskip("playwright.sync_api")
    with playwright.sync_playwright() as play:
        browser = play.chromium.launch(executable_path=chromium)
        yield browser
        browser.close()


@pytest.fixture
def opened(browser):
    """A function that opens the page, at an address, as a desktop or (phone=True) a phone.

    Whatever the page asks of a network, and every error it meets, fails the test.
    """
    contexts, faults = [], []

    def open_page(address="", *, phone=False, **options):
        shape = {"width": 390, "height": 844} if phone else {"width": 1280, "height": 800}
        context = browser.new_context(
            viewport=shape, is_mobile=phone, has_touch=phone, reduced_motion="reduce", **options
        )
        contexts.append(context)
        page = context.new_page()
        page.set_default_timeout(30_000)  # only a failure waits so long
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.on("console", lambda said: faults.append(said.text) if said.type == "error" else None)
        page.on(
            "request",
            lambda asked: None if asked.url.startswith("file:") else faults.append(asked.url),
        )
        page.goto(f"{PAGE.as_uri()}{address}")
        return page

    yield open_page
    for context in contexts:
        context.close()
    assert faults == []


@pytest.fixture(scope="session")
def computed(browser):
    """A function that calls one of the page's own functions: computed("answers", text)."""
    page = browser.new_page()
    page.goto(PAGE.as_uri())
    call = "([name, text]) => JSON.stringify(window.collisionCourse[name](JSON.parse(text)))"
    yield lambda name, argument: json.loads(page.evaluate(call, [name, json.dumps(argument)]))
    page.close()
