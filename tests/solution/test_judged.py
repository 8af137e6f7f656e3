"""The reference and the naive solver, judged as a contestant's programs would be."""

import pytest

from judge.judging import Options, judge
from judge.kit.paths import DATA, ROOT
from judge.languages.submission import read_submission
from judge.problem.cases import find_cases
from judge.problem.declaration import load

PROBLEM = load()
BUILT = {case.group for case in find_cases(DATA, PROBLEM)}

EXPECTED = {
    "solution.py": ["AC", "AC", "AC", "AC", "AC"],
    "brute.py": ["AC", "AC", "AC", "TLE", "TLE"],
}


@pytest.mark.parametrize("program", EXPECTED)
def test_the_two_solvers_on_the_first_committed_cases(program):
    options = Options(groups=("sample", "static", "small"), globs=("*/0?-*",))
    judging = judge(read_submission(ROOT / program), PROBLEM, options)
    assert {group.verdict for group in judging.groups} == {"AC"}


@pytest.mark.slow
@pytest.mark.parametrize("program", EXPECTED)
def test_verdicts_of_the_two_solvers(program):
    missing = set(PROBLEM.group_names) - BUILT
    if missing:
        pytest.skip(f"no data for {', '.join(sorted(missing))}: run 'make data'")
    judging = judge(read_submission(ROOT / program), PROBLEM, Options(stop_on_first=True))
    assert [group.verdict for group in judging.groups] == EXPECTED[program]
    assert judging.max_score == 100
    assert judging.score == {"solution.py": 100, "brute.py": 30}[program]
