"""The built page as a file, what it holds, and the command that writes it."""

import json
import re

import pytest

from explorer import cli
from explorer.page import build
from explorer.scenes import gallery, samples
from judge.kit.paths import DATA
from judge.problem import declaration

LESSONS = """
[touch]
sentence = "A corner that touches </script> is a collision."

[empty]
sentence = "Nothing is there to be touched."
"""
SCENES = '''
[[scenes]]
name = "no-obstacle"
lesson = "empty"
answer = "YES"
input = """
3 0
5 5
0 0
1 0
0 1
"""

[[scenes]]
name = "corner-touches"
lesson = "touch"
answer = "NO"
input = """
3 1
0 0
0 0
1 0
0 1
3
1 0
2 0
2 1
"""
'''


@pytest.fixture
def directory(tmp_path):
    """A gallery of two scenes."""
    for name, text in (("lessons.toml", LESSONS), ("scenes.toml", SCENES), ("answers.json", "{}")):
        (tmp_path / name).write_text(text)
    return tmp_path


def built(directory):
    return build([*samples(), *gallery(directory)], declaration.load().constraints)


def test_the_page_is_current():
    assert cli.main(["--check"]) == 0, "run: python -m explorer"


def test_the_page_is_small_and_loads_nothing():
    page = cli.PAGE.read_text()
    assert len(page.encode()) < 150_000
    assert set(re.findall(r"https?://[\w./]+", page)) == {"http://www.w3.org/2000/svg"}
    assert "default-src 'none'" in page
    assert not re.search(r"\b(fetch|XMLHttpRequest|WebSocket|sendBeacon|eval)\b|innerHTML", page)


def test_every_scenario_of_the_samples_is_held():
    scenes = samples()
    answers = [
        answer
        for file in sorted((DATA / "sample").glob("*.ans"))
        for answer in file.read_text().split()
    ]
    assert [scene.answer for scene in scenes] == answers
    assert scenes[0].name == "01-first-1"
    assert scenes[0].sentence.startswith("In scenario 1 the robot passes between both obstacles.")
    assert "![" not in "".join(scene.sentence for scene in scenes)


def test_a_gallery_is_held_in_the_order_of_its_lessons(directory):
    first, second = gallery(directory)
    assert (first.name, first.title, first.answer) == ("corner-touches", "corner touches", "NO")
    assert (first.group, second.group) == ("Gallery: touch", "Gallery: empty")
    assert first.input == "3 1\n0 0\n0 0\n1 0\n0 1\n3\n1 0\n2 0\n2 1\n"
    page = built(directory)
    data = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)
    held = json.loads(data[1])
    assert held["sentences"].count(first.sentence) == 1
    assert held["scenes"][-1]["input"] == second.input


@pytest.mark.slow  # a scene of the shipped page opens by its link in a fast test
def test_gallery_scenes_open_by_name_in_the_browser(browser, directory, tmp_path):
    file = tmp_path / "explorer.html"
    file.write_text(built(directory))
    page = browser.new_page()
    page.goto(f"{file.as_uri()}#gallery=corner-touches")
    page.locator("#lesson", has_text="A corner that touches </script> is a collision.").wait_for()
    page.locator("#answer", has_text="NO").wait_for()
    page.locator("#next").click()
    page.locator("#answer", has_text="YES").wait_for()
    assert page.locator("#scenes").input_value() == "no-obstacle"
    page.close()


def test_the_command_writes_and_checks(tmp_path, capsys):
    file = tmp_path / "page.html"
    assert cli.main(["--check", "--output", str(file)]) == 1
    assert "is not current: run 'python -m explorer'" in capsys.readouterr().out
    assert cli.main(["--output", str(file)]) == 0
    assert cli.main(["--check", "--output", str(file)]) == 0
    file.write_text(file.read_text() + " ")
    assert cli.main(["--check", "--output", str(file)]) == 1
    assert cli.main(["--output", str(tmp_path / "none" / "page.html")]) == 2
    assert capsys.readouterr().err.count("\n") == 1
