"""Each submission gets, in each group, the verdict that problem.toml declares for it.

A group ends at its first failure, which decides its verdict. The groups whose files
are rebuilt, not committed, are left out while they are not built. Each is judged once:
compilers take their time.
"""

import pytest

from judge.judging import Options, judge, machine_scale
from judge.kit.paths import DATA, ROOT
from judge.languages.submission import read_submission
from judge.languages.table import LanguageError, toolchain
from judge.problem.cases import find_cases
from judge.problem.declaration import load
from judge.sandbox.sandbox import Sandbox

PROBLEM = load()
GROUPS = PROBLEM.group_names
BUILT = {case.group for case in find_cases(DATA, PROBLEM)}
COMMITTED = [name for name in GROUPS if name in ("sample", "static", "small")]
REBUILT = [name for name in GROUPS if name not in COMMITTED]


@pytest.fixture(scope="session")
def scale():
    """How many times slower than the calibrating machine this one is; timed once."""
    with Sandbox() as sandbox:
        return machine_scale(PROBLEM, sandbox) or 1.0


def verdicts(name, groups, scale):
    """Judge a submission; return its verdict in each of the groups, with the case that decided."""
    submission = read_submission(ROOT / "submissions" / name)
    try:
        toolchain(submission.language)
    except LanguageError as error:
        pytest.skip(str(error))
    options = Options(groups=tuple(groups), stop_on_first=True, scale=scale)
    outcome = judge(submission, PROBLEM, options)
    return {group.name: group for group in outcome.groups}


def differences(name, groups, scale):
    """Return a line for each group whose verdict is not a declared one."""
    lines = []
    for group, result in verdicts(name, groups, scale).items():
        permitted = PROBLEM.expected(name, group)
        if result.verdict not in permitted:
            failed = [r for r in result.cases if r.verdict not in (None, "AC")]
            where = f" at {failed[0].case.name}: {failed[0].message}" if failed else ""
            lines.append(
                f"{name}: {group}: expected {'|'.join(sorted(permitted))}, "
                f"found {result.verdict}{where}"
            )
    return lines


def decided(name):
    """Return the groups to judge it on: all that are committed, and some that are rebuilt.

    Where two verdicts are permitted (`WA|TLE`: wrong, and too slow), to learn which of them
    it is costs a whole time limit and shows nothing.
    """
    one = [group for group in REBUILT if len(PROBLEM.expected(name, group)) == 1]
    return COMMITTED + one


@pytest.mark.parametrize("name", PROBLEM.submissions)
def test_verdicts(name, scale):
    groups = [group for group in decided(name) if group in BUILT]
    assert differences(name, groups, scale) == []


def test_the_rebuilt_groups_were_among_them():
    missing = [group for group in REBUILT if group not in BUILT]
    if missing:
        pytest.skip(f"no data for {', '.join(missing)}: run 'make data'")
    assert {group for name in PROBLEM.submissions for group in decided(name)} == set(GROUPS)
