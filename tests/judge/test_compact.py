"""The small selection of cases: its file, what is refused, and a judging with it."""

import re

import pytest

from judge.cli import main
from judge.kit.paths import DATA, REFERENCE
from judge.problem.cases import Case
from judge.problem.compact import COMPACT, CompactError, compact_cases, save_compact
from judge.problem.data import load_data
from judge.problem.declaration import load

CASES = [
    Case(f"secret/{group}/{number}", group, DATA, DATA)
    for group in ("small", "large")
    for number in (1, 2, 3)
]
CHOSEN = {"small": ["secret/small/2"], "large": ["secret/large/3", "secret/large/1"]}


def test_the_named_cases_are_chosen_in_the_given_order(tmp_path):
    save_compact(tmp_path, CHOSEN)
    names = [case.name for case in compact_cases(tmp_path, CASES)]
    assert names == ["secret/small/2", "secret/large/1", "secret/large/3"]


@pytest.mark.parametrize(
    ("groups", "message"),
    [
        (
            CHOSEN | {"small": ["secret/small/22"]},
            "secret/small/22: no such test case; did you mean 'secret/small/2'?; "
            "'python -m strength --compact' chooses anew",
        ),
        (CHOSEN | {"small": ["secret/large/2"]}, "secret/large/2: is not in the group small"),
        (CHOSEN | {"small": []}, "group small: expected cases, found none"),
        ({"small": ["secret/small/2"]}, "group large: expected cases, found none"),
    ],
)
def test_a_selection_that_does_not_fit_is_refused(tmp_path, groups, message):
    save_compact(tmp_path, groups)
    with pytest.raises(CompactError, match=r"compact\.json: ") as caught:
        compact_cases(tmp_path, CASES)
    assert message in str(caught.value)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (None, "no such file; 'python -m strength --compact' chooses anew"),
        ("{", "not a selection of cases"),
        ('{"version": 1, "groups": {}, "more": 1}', "not a selection of cases"),
        ('{"version": 2, "groups": {}}', "expected version 1, found 2"),
    ],
)
def test_a_damaged_file_is_refused(tmp_path, content, message):
    if content is not None:
        (tmp_path / COMPACT).write_text(content)
    with pytest.raises(CompactError) as caught:
        compact_cases(tmp_path, CASES)
    assert message in str(caught.value)


def test_groups_and_globs_choose_from_the_selection():
    whole = load_data(load(), groups=["static"])
    data = load_data(load(), groups=["static"], compact=True)
    assert data.partial
    assert 0 < len(data.chosen) < len(whole.chosen)
    assert set(data.chosen) < set(whole.chosen)


def test_a_compact_judging_says_that_it_is_partial(capsys):
    assert main([str(REFERENCE), "--compact", "--group", "static"]) == 0
    printed = capsys.readouterr().out
    assert "partial: not all of the kit's cases" in printed
    chosen = len(load_data(load(), groups=["static"], compact=True).chosen)
    assert len(re.findall(r"^AC .* secret/static/", printed, re.MULTILINE)) == chosen
