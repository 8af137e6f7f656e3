"""The page of a judging: it needs nothing else, tells everything, and escapes what it shows."""

from __future__ import annotations

import base64
import re
from collections.abc import Callable
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from subprocess import CompletedProcess

import pytest

from judge.explanation import Diagnosis, Like, MissedLesson
from judge.problem.verdict import Verdict
from judge.reports.html import MEANING, to_html
from judge.results import CaseResult, GroupResult, Judging, Scale, not_run

from .conftest import WRONG
from .test_explained import DIAGNOSIS, EXAMPLE, ILLUSTRATED, SCENE, failed
from .test_feedback import FIRST, SECOND, THIRD

NAMES = ["<b>", "&amp;<b>", '"><script>x</script>', "{{ 7 * 7 }}", "\u202eyp", "\x1b[2J", "' x='"]
VOID = {"meta", "img", "br", "hr", "input", "link"}
Source = Callable[[str, str], Path]


class Reader(HTMLParser):
    """Reads a page; every tag must be closed in order. Keeps texts, tags and attributes."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.texts: list[str] = []
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.feed(page)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.texts.append(data)


def judging(*results: CaseResult) -> Judging:
    verdict = next((r.verdict for r in results if r.verdict not in (None, "AC")), Verdict.AC)
    assert verdict is not None
    group = GroupResult("small", verdict, 0, 15, True, results)
    return Judging("a.py", "Python 3", verdict, 0, 100, False, 5.0, 5.0, 512, None, (group,))


def test_it_tells_everything() -> None:
    results = (
        CaseResult(FIRST, Verdict.AC, 1.25, 1.5, 9.0),
        CaseResult(SECOND, Verdict.TLE, 6.5, 7.0, 9.0, "6.50 s of CPU time, limit 5.00 s"),
        not_run(THIRD, "an earlier case of its group failed"),
    )
    drawn = replace(EXAMPLE, picture="<svg>picture</svg>", file=Path("/x/kept.in"))
    told = replace(
        judging(*results),
        scale=Scale(1.5, "measured"),
        diagnosis=DIAGNOSIS,
        counterexample=drawn,
        wall="bubblewrap",
    )
    page = to_html(told).decode()
    read = Reader(page)
    text = re.sub(r"\s+", " ", " ".join(read.texts))
    for words in [
        *("time limit exceeded", "0 of 15", "secret/small/beta", "6.50 s of CPU time"),
        *("Sentence number 4.", "scene-4", "takes touching for free", "A remark."),
        *(EXAMPLE.sentence, "kept.in", "seed 7 repeats this search", "1 obstacle, 6 vertices"),
        *("machine scale 1.50 (measured)", "bubblewrap", "512 MiB"),
        "1 case not run: an earlier case of its group failed",
    ]:
        assert words.lower() in text.lower(), words
    assert EXAMPLE.input in page
    assert re.findall(r'style="width: ([\d.]+)%"', page) == ["25.0", "100.0"]
    (picture,) = (attributes["src"] for tag, attributes in read.tags if tag == "img")
    assert picture is not None
    head, _, content = picture.partition(",")
    assert head == "data:image/svg+xml;base64"
    assert base64.b64decode(content).decode() == drawn.picture


def test_the_scenes_of_lessons_have_their_pictures() -> None:
    """The first is open where no counterexample says more."""
    told = replace(failed(FIRST), diagnosis=ILLUSTRATED, counterexample=EXAMPLE)
    read = Reader(to_html(told).decode())
    (picture,) = (attributes["src"] for tag, attributes in read.tags if tag == "img")
    assert picture is not None
    assert base64.b64decode(picture.partition(",")[2]).decode() == SCENE.picture
    assert "scene-4: expected NO, found no answer" in "".join(read.texts)
    assert SCENE.sentence in "".join(read.texts)
    first = replace(ILLUSTRATED, lessons=ILLUSTRATED.lessons[::-1])
    for lessons, example, is_open in (
        (ILLUSTRATED, None, False),
        (first, EXAMPLE, False),
        (first, None, True),
    ):
        page = to_html(replace(told, diagnosis=lessons, counterexample=example)).decode()
        (details,) = (given for tag, given in Reader(page).tags if tag == "details")
        assert ("open" in details) is is_open


def test_a_long_crash_is_folded() -> None:
    crash = "crash: exit status 1: " + "x" * 90 + "\nline two"
    page = to_html(replace(failed(FIRST), counterexample=replace(EXAMPLE, found=crash))).decode()
    texts = Reader(page).texts
    assert f"{crash[:80]}…" in texts
    assert crash in texts
    assert "all that was found" in texts
    assert (
        "all that was found" not in to_html(replace(failed(FIRST), counterexample=EXAMPLE)).decode()
    )


def test_it_tells_why_there_is_no_counterexample() -> None:
    page = to_html(replace(failed(FIRST), unexplained="nothing <smaller> fails")).decode()
    assert "nothing &lt;smaller&gt; fails" in page
    Reader(page)


def test_it_needs_nothing_else() -> None:
    page = to_html(replace(failed(FIRST), diagnosis=DIAGNOSIS, counterexample=EXAMPLE)).decode()
    assert not re.search(r"<script|<link|src=|href=|url\(|@import|https?:", page)
    assert "prefers-color-scheme: dark" in page
    assert "@media print" in page
    tags = [tag for tag, _ in Reader(page).tags]
    assert tags.count("h1") == 1
    assert tags.count("main") == 1
    heads = [attributes for tag, attributes in Reader(page).tags if tag == "th"]
    assert heads
    assert all(attributes.get("scope") for attributes in heads)


@pytest.mark.parametrize("name", NAMES)
def test_what_others_wrote_is_text(name: str) -> None:
    """Names, output, lessons: none makes a tag, an attribute or a template."""
    case = replace(FIRST, name=f"secret/{name}/1")
    example = replace(
        EXAMPLE, input=name, found=name, sentence=name, steps=(name,), file=Path(f"/{name}")
    )
    lesson = MissedLesson(name, name, (name,))
    told = replace(
        failed(case, name, stderr=name),
        submission=name,
        diagnosis=Diagnosis((lesson,), Like(name, name), name, 1, 1),
        counterexample=example,
    )
    hostile, plain = to_html(told).decode(), to_html(replace(told, **harmless(told))).decode()
    assert [tag for tag, _ in Reader(hostile).tags] == [tag for tag, _ in Reader(plain).tags]
    assert all(c.isprintable() or c == "\n" for c in hostile)
    shown = name if name.isprintable() else name.encode("unicode_escape").decode()
    assert shown in "".join(Reader(hostile).texts)


def harmless(told: Judging) -> dict[str, object]:
    """Return the fields of `told` with an x for each name."""
    case = replace(FIRST, name="secret/x/1")
    lesson = MissedLesson("x", "x", ("x",))
    return {
        "submission": "x",
        "groups": failed(case, "x", stderr="x").groups,
        "diagnosis": Diagnosis((lesson,), Like("x", "x"), "x", 1, 1),
        "counterexample": replace(
            EXAMPLE, input="x", found="x", sentence="x", steps=("x",), file=Path("/x")
        ),
    }


@pytest.mark.parametrize("verdict", Verdict)
def test_every_verdict_has_its_words(verdict: Verdict) -> None:
    told = replace(judging(CaseResult(FIRST, verdict, 0.1, 0.1, 9.0)), verdict=verdict)
    page = to_html(replace(told, message="line 1: error")).decode()
    assert MEANING[verdict].capitalize() in page
    assert ("line 1: error" in page) is (verdict is Verdict.CE)
    Reader(page)


def test_from_the_command_line(
    checker: Callable[..., CompletedProcess[str]], source: Source, data: Path, tmp_path: Path
) -> None:
    path = source("w.py", WRONG)
    done = checker(path, "--data", data, "--html", tmp_path / "report.html")
    assert done.returncode == 1
    Reader((tmp_path / "report.html").read_text())
    for arguments, words in [
        (("--html", tmp_path / "no" / "x.html"), "--html"),
        (("--html", path), "found the submission"),
        (("--html", tmp_path / "x", "--json", tmp_path / "x"), "found the file of --json"),
        (("--html", "-"), "found standard output"),
    ]:
        refused = checker(path, "--data", data, *arguments)
        assert (refused.returncode, refused.stdout) == (2, "")
        assert words in refused.stderr
