"""Campaigns: what is killed, what survives, what was called equivalent and is not."""

import pytest

from judge.kit.paths import DATA
from judge.problem.cases import Case, find_cases
from judge.problem.declaration import load
from judge.problem.verdict import Verdict
from strength.mutants import equivalents
from strength.mutants.campaign import CampaignError, light_groups, plan_for, programs, run, sample
from strength.mutants.equivalents import Equivalent
from strength.mutants.mutate import mutants

PROBLEM = load()
PROGRAM = "limit = 3\nprint('YES' if int(input()) < limit else 'NO')\n"


@pytest.fixture
def little(tmp_path):
    """A program, and two cases that leave one of its mutants alive: 4 for 3, 2 for 3."""
    (tmp_path / "solution.py").write_text(PROGRAM)
    cases = []
    for number, answer in ((1, "YES"), (9, "NO")):
        files = tmp_path / f"{number}.in", tmp_path / f"{number}.ans"
        for path, text in zip(files, (str(number), answer), strict=True):
            path.write_text(f"{text}\n")
        cases.append(Case(f"secret/small/{number}", "small", *files))
    return tmp_path, [plan_for("solution.py", cases, PROBLEM, heavy=True)]


def outcome(little, entries=()):
    root, plans = little
    return run(plans, entries, PROBLEM, jobs=1, root=root)


def test_killed_and_survived(little):
    campaign = outcome(little)
    by_change = {f.mutant.mutated: f for f in campaign.findings}
    assert by_change["limit = 4"].survived
    assert by_change["limit = 2"].survived
    assert by_change["print('YES' if int(input()) <= limit else 'NO')"].survived
    assert by_change["pass"].kill.verdict in (Verdict.RTE, Verdict.WA)
    turned = by_change["print('YES' if int(input()) > limit else 'NO')"]
    assert turned.kill.case == "secret/small/1"
    assert not campaign.ok


def test_what_is_listed_and_survives_is_well_and_what_is_killed_is_stale(little):
    def entry(line, *mutated):
        return Equivalent(program="solution.py", line=line, mutated=list(mutated), proof="so")

    test = "print('YES' if int(input()) < limit else 'NO')"
    listed = [entry("limit = 3", "limit = 4", "limit = 2"), entry(test, test.replace("<", "<="))]
    assert outcome(little, listed).ok
    killed = [*listed, entry(test, test.replace("<", ">"))]
    assert [f.mutant.mutated for f in outcome(little, killed).findings if f.stale] == [
        test.replace("<", ">")
    ]
    assert not outcome(little, [*listed, entry("gone", "away")]).ok


def test_a_program_that_fails_as_it_is_stops_the_campaign(little):
    root, _ = little
    (root / "solution.py").write_text("print('YES')\n")
    with pytest.raises(CampaignError, match=r"expected AC on secret/small/9 as it is, found WA"):
        outcome(little)


def test_equal_seeds_give_equal_samples():
    every = mutants("p.py", PROGRAM.encode())
    assert sample(every, 5, 1) == sample(every, 5, 1) != sample(every, 5, 2)
    assert sample(every, 1_000, 1) == every


@pytest.mark.parametrize(
    "size",
    [9, pytest.param(60, marks=pytest.mark.slow)],
)
def test_a_sample_of_the_real_campaign(size):
    # Size and time show on the large files only; here are the small ones, and so only
    # what those must kill: the textbook program in its own words.
    cases = [c for c in find_cases(DATA, PROBLEM) if c.group in light_groups(PROBLEM)]
    plans = [plan_for(name, cases, PROBLEM, heavy=False) for name in programs(PROBLEM)]
    campaign = run(plans, equivalents.load(), PROBLEM, jobs=2, quick=size)
    assert len(campaign.findings) == size
    assert not [str(f.mutant) for f in campaign.findings if f.stale]
    assert sum(f.kill is not None for f in campaign.findings) > size * 2 // 3
