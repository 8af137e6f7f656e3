"""Each submission gets, in each group, the verdict that problem.toml declares for it.

A group ends at its first failure, which decides its verdict. Groups whose files are not
committed are left out until `make data` has built them.

To judge all submissions on all groups takes minutes: that is `slow`. The fast tests judge the
accepted Python submissions, every fourth other one and one compiled one on the committed groups.
Of a group where AC is expected, they judge only the first cases.
"""

import msgspec
import pytest

from judge.judging import Options, judge
from judge.kit.paths import DATA, SUBMISSIONS
from judge.languages.submission import read_submission
from judge.languages.table import LanguageError
from judge.languages.toolchain import toolchain
from judge.problem.cases import find_cases
from judge.problem.declaration import Feedback, load

PROBLEM = load()
# Without a diagnosis, which runs the program again.
QUIET = msgspec.structs.replace(PROBLEM, feedback=Feedback(tell="verdict", name_secret_cases=True))
GROUPS = PROBLEM.group_names
BUILT = {case.group for case in find_cases(DATA, PROBLEM)}
COMMITTED = [name for name in GROUPS if name in ("sample", "static", "small")]
REBUILT = [name for name in GROUPS if name not in COMMITTED]
PYTHON = [name for name in PROBLEM.submissions if name.endswith(".py")]
SOME = [*(n for n in PYTHON if n.startswith("accepted/")), *PYTHON[::4]]
COMPILED = "accepted/textbook.cpp"  # one stands for all: compiling is tested elsewhere


def differences(name, groups, globs=()):
    """Judge a submission; return a line for each group whose verdict is not a declared one."""
    submission = read_submission(SUBMISSIONS / name)
    try:
        toolchain(submission.language)
    except LanguageError as error:
        pytest.skip(str(error))
    options = Options(groups=tuple(groups), globs=tuple(globs), stop_on_first=True)
    lines = []
    for result in judge(submission, QUIET, options).groups:
        permitted = PROBLEM.expected(name, result.name)
        if result.verdict not in permitted:
            failed = [r for r in result.cases if r.verdict not in (None, "AC")]
            where = f" at {failed[0].case.name}: {failed[0].message}" if failed else ""
            lines.append(
                f"{name}: {result.name}: expected {'|'.join(sorted(permitted))}, "
                f"found {result.verdict}{where}"
            )
    return lines


def passed(name, groups):
    return [group for group in groups if PROBLEM.expected(name, group) == {"AC"}]


def decided(name):
    """Return the groups to judge it on: the committed ones, and most of those that are rebuilt.

    A rebuilt group that permits two verdicts (`WA|TLE`: wrong, and too slow) is left out: which
    of them occurs costs a whole time limit and shows nothing.
    """
    one = [group for group in REBUILT if len(PROBLEM.expected(name, group)) == 1]
    return COMMITTED + one


@pytest.mark.parametrize("name", sorted({*SOME, COMPILED}))
def test_verdicts_on_committed_cases(name):
    passes = passed(name, COMMITTED)
    fails = [group for group in COMMITTED if group not in passes]
    found = differences(name, fails) if fails else []
    if passes:
        found += differences(name, passes, ["*/0?-*"])  # the first nine of each group
    assert found == []


@pytest.mark.slow
@pytest.mark.usefixtures("compiled_once")
@pytest.mark.parametrize("name", PROBLEM.submissions)
def test_verdicts(name):
    groups = [group for group in decided(name) if group in BUILT]
    assert differences(name, groups) == []


def test_every_group_is_decided_by_some_submission():
    assert {group for name in PROBLEM.submissions for group in decided(name)} == set(GROUPS)


@pytest.mark.slow
def test_the_rebuilt_groups_are_built():
    missing = [group for group in REBUILT if group not in BUILT]
    if missing:
        pytest.skip(f"no data for {', '.join(missing)}: run 'make data'")
