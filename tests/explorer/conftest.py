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


@pytest.fixture(scope="session")
def contexts(browser):
    """Two windows, by whether they are a phone's. A new one takes Chromium a second."""
    return {
        is_phone: browser.new_context(
            viewport={"width": 390, "height": 844} if is_phone else {"width": 1280, "height": 800},
            is_mobile=is_phone,
            has_touch=is_phone,
            reduced_motion="reduce",
        )
        for is_phone in (False, True)
    }


@pytest.fixture
def opened(contexts):
    """A function that opens the page afresh, at an address, on a desktop or (phone=True) a phone.

    Whatever the page asks of a network, and every error it meets, fails the test.
    """
    used, faults = [], []

    def on_request(asked):
        if not asked.url.startswith("file:"):
            faults.append(asked.url)

    listeners = {
        "pageerror": lambda error: faults.append(str(error)),
        "console": lambda said: faults.append(said.text) if said.type == "error" else None,
        "request": on_request,
    }

    def open_page(address="", *, phone=False):
        context = contexts[phone]
        page = next((page for page in context.pages if page not in used), None)
        page = page or context.new_page()
        used.append(page)
        page.set_default_timeout(30_000)  # only a failure waits so long
        page.goto("about:blank")
        for event, listener in listeners.items():
            page.on(event, listener)
        page.goto(f"{PAGE.as_uri()}{address}")
        return page

    yield open_page
    for page in used:
        for event, listener in listeners.items():
            page.remove_listener(event, listener)
    assert faults == []


@pytest.fixture(scope="session")
def computed(browser):
    """A function that calls one of the page's own functions: computed("answers", text)."""
    page = browser.new_page()
    page.goto(PAGE.as_uri())
    call = "([name, text]) => JSON.stringify(window.collisionCourse[name](JSON.parse(text)))"
    yield lambda name, argument: json.loads(page.evaluate(call, [name, json.dumps(argument)]))
    page.close()
