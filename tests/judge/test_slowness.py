"""A program that was too slow: what is said of the test case, and of how its time grows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

import msgspec
import pytest
from rich.console import Console

from judge.diagnosis.slowness import first_timeout, size_of
from judge.explanation import Growth, Size, Slowness
from judge.feedback import told
from judge.judging import Failure, Options, judge
from judge.kit.errors import KitError
from judge.kit.paths import DATA
from judge.languages.submission import read_submission
from judge.problem.cases import Case, case_at
from judge.problem.declaration import Feedback, load
from judge.problem.manifest import Manifest, load_manifest
from judge.problem.verdict import Verdict
from judge.reports.html import to_html
from judge.reports.schema import report_of, to_json
from judge.reports.slowness import slow_sentences
from judge.reports.terminal import print_report
from judge.results import CaseResult, GroupResult, Judging

from .conftest import QUIET

PROBLEM = load()
Judged = Callable[..., Judging]
TRIANGLE = "0 0\n1 0\n0 1\n"
SQUARE = "4\n0 0\n1 0\n1 1\n0 1\n"
# A robot of 3 without obstacles, and a robot of 4 with a triangle and a square.
TWO = f"2\n3 0\n0 0\n{TRIANGLE}4 2\n1 0\n0 0\n1 0\n1 1\n0 1\n3\n{TRIANGLE}{SQUARE}"
SIZE = Size(
    case="secret/many/01",
    family="hugging",
    promise="no further promise",
    scenarios=1,
    robot=250_000,
    obstacles=83_333,
    obstacle=3,
    walks=20_833_250_000,
    pairs=62_499_750_000,
)
FAST = Growth("triangles", "the number of x", (1000, 2000), (0.12, 0.47), 4000, 1.97, 1.0, True)
SLOW = replace(FAST, ladder="robot", quantity="the number of y", exponent=1.02, too_fast=False)


def judging(slowness: Slowness | None, case: str = SIZE.case) -> Judging:
    """A judging whose only case is too slow."""
    result = CaseResult(Case(case, "many", Path(), Path()), Verdict.TLE, 5.1, 5.2, 9.0, "5.1 s")
    group = GroupResult("many", Verdict.TLE, 0, 20, True, (result,))
    return Judging(
        *("a.py", "Python 3", Verdict.TLE, 0, 100, True, 5.0, 5.0, 512, None, (group,)),
        slowness=slowness,
    )


def test_the_sizes_of_a_case_are_counted(tmp_path: Path) -> None:
    case = case_at(tmp_path, "secret/many/01")
    case.input.parent.mkdir(parents=True)
    case.input.write_text(TWO)
    size = size_of(case, PROBLEM, Manifest(1, {}))
    assert size == Size("secret/many/01", "", "no further promise", 2, 4, 2, 4, 8, 4 * 7)
    case.input.write_text(TWO[:-4])
    assert size_of(case, PROBLEM, Manifest(1, {})) is None
    case.input.write_text("YES\n")
    assert size_of(case, PROBLEM, Manifest(1, {})) is None


def test_the_sizes_of_the_kits_cases_are_those_of_the_manifest() -> None:
    manifest = load_manifest(DATA)
    for name in ("sample/01-first", "secret/static/39-large-robot", "secret/small/21-mixture"):
        size, entry = size_of(case_at(DATA, name), PROBLEM, manifest), manifest.cases[name]
        assert size is not None
        assert (size.walks, size.scenarios, size.family) == (
            *(entry.pair_sum, entry.scenarios),
            entry.family,
        )


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({}, "walk around the robot for each obstacle takes 20,833,250,000 steps here"),
        ({}, "has a robot of 250,000 vertices and 83,333 obstacles of up to 3 vertices"),
        ({}, "(family hugging)"),
        ({}, "the promise of its group: no further promise"),
        ({"walks": 10**6}, "takes 62,499,750,000 steps here; one walk around the robot"),
        ({"walks": 10, "pairs": 30}, "takes only 30 steps here"),
        ({"scenarios": 9}, "9 scenarios, with robots of up to 250,000 vertices and up to 83,333"),
        ({"obstacles": 0, "obstacle": 0}, "a robot of 250,000 vertices and 0 obstacles;"),
        ({"family": "", "promise": "", "case": "mine/1"}, "mine/1 has a robot of"),
    ],
)
def test_what_is_special_in_a_case(changes: dict[str, int | str], words: str) -> None:
    said = slow_sentences(Slowness(replace(SIZE, **changes)))  # type: ignore[arg-type] # by name
    assert len(said) == 2
    assert words in " ".join(said)


@pytest.mark.parametrize(
    ("growths", "words"),
    [
        (
            (FAST, SLOW),
            [
                "Its time grows like N^2.0, where N is the number of x: 0.12 s at 1,000, 0.47 s at "
                "2,000; aim at about N^1."
            ],
        ),
        (
            (replace(FAST, may=0.0),),
            [
                "Its time grows like N^2.0, where N is the number of x: 0.12 s at 1,000, 0.47 s at "
                "2,000; aim at a time that does not depend on N."
            ],
        ),
        (
            (SLOW,),
            [
                "In what was measured, no quantity makes its time grow faster than it may. The "
                "longest time: 0.47 s at 2,000, where N is the number of y."
            ],
        ),
        (
            (replace(SLOW, sizes=(), cpu_s=(), exponent=None, over=256), SLOW),
            ["It is too slow to be measured at N = 256, where N is the number of y."],
        ),
        (
            (replace(SLOW, exponent=None, sizes=(512,), cpu_s=(0.2,), over=1024),),
            [
                "It is too slow to be measured at N = 1,024, where N is the number of y (0.20 s at "
                "512)."
            ],
        ),
        ((replace(SLOW, sizes=(), cpu_s=(), exponent=None, over=None),), []),
        ((), []),
    ],
)
def test_how_its_time_grows(growths: tuple[Growth, ...], words: list[str]) -> None:
    assert slow_sentences(Slowness(None, growths)) == words


def test_every_report_tells_it() -> None:
    found = judging(Slowness(SIZE, (FAST, SLOW)))
    console = Console(width=80, markup=False, highlight=False)
    with console.capture() as captured:
        print_report(console, found)
    page = to_html(found).decode()
    for sentence in slow_sentences(Slowness(SIZE, (FAST, SLOW))):
        assert sentence in captured.get()
        assert sentence in page
    report = msgspec.json.decode(to_json(found))["slowness"]
    assert report["size"] == {name: getattr(SIZE, name) for name in SIZE.__slots__}
    assert report["growths"][0]["exponent"] == 1.97
    assert [growth["ladder"] for growth in report["growths"]] == ["triangles", "robot"]
    assert report_of(judging(None)).slowness is None
    assert "why it is too slow" not in to_html(judging(None)).decode().lower()


@pytest.mark.parametrize(
    ("tell", "named", "case", "kept"),
    [
        ("counterexample", True, SIZE.case, Slowness(SIZE, (FAST,))),
        ("lessons", True, SIZE.case, Slowness(SIZE, (FAST,))),
        ("lessons", False, SIZE.case, Slowness(None, (FAST,))),
        ("lessons", False, "sample/01", Slowness(replace(SIZE, case="sample/01"), (FAST,))),
        ("verdict", True, SIZE.case, None),
    ],
)
def test_the_setter_decides_how_much_is_told(
    tell: str, named: bool, case: str, kept: Slowness | None
) -> None:
    feedback = msgspec.convert({"tell": tell, "name_secret_cases": named}, Feedback)
    found = judging(Slowness(replace(SIZE, case=case), (FAST,)), case)
    permitted = told(found, feedback)
    assert permitted.slowness == kept
    unmeasured = replace(found, slowness=Slowness(replace(SIZE, case=case)))
    assert (told(unmeasured, feedback).slowness is None) == (kept is None or kept.size is None)
    assert (SIZE.case.encode() in to_json(permitted)) == (named and case == SIZE.case)


@pytest.fixture
def endless(tmp_path: Path) -> Judged:
    """A function that judges a program that never ends, on one small case."""
    case = case_at(tmp_path / "data", "secret/small/01")
    case.input.parent.mkdir(parents=True)
    case.input.write_text(TWO)
    case.answer.write_text("YES\nNO\n")
    program = tmp_path / "endless.py"
    program.write_text("while True: pass\n")
    options = Options(data=tmp_path / "data", no_wall=True, time_limit_s=0.2)
    return partial(judge, read_submission(program), options=options)


def test_a_judging_tells_it_and_measures_on_request(endless: Judged) -> None:
    outcome = endless(PROBLEM, measure=lambda _failure: (FAST,))
    late = first_timeout(outcome.cases)
    assert late is not None
    assert outcome.slowness is not None
    assert outcome.slowness.growths == (FAST,)
    assert outcome.slowness.size == size_of(late.case, PROBLEM, Manifest(1, {}))


@pytest.mark.slow
def test_a_measurement_that_fails_or_may_not_be_told_costs_only_itself(endless: Judged) -> None:
    def fails(_failure: Failure) -> tuple[Growth, ...]:
        raise KitError("no more scratch space")

    failed = endless(PROBLEM, measure=fails)
    assert failed.slowness is not None
    assert (failed.slowness.growths, failed.unexplained) == ((), "no more scratch space")
    quiet = endless(QUIET, measure=fails)
    assert (quiet.slowness, quiet.unexplained) == (None, "")
