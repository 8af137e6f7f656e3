"""The search for a smallest counterexample: of submissions of the kit, and of small programs."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

import pytest

from gen.geometry import cross, minus
from gen.scenario import Scenario, parse, render
from judge.decide import Judgement
from judge.explanation import Counterexample
from judge.kit.paths import DATA, SUBMISSIONS
from judge.languages.submission import read_submission
from judge.languages.table import LanguageError
from judge.pool import Job, Pool
from judge.problem.cases import case_at
from judge.problem.declaration import load
from judge.problem.verdict import Verdict
from judge.results import CaseResult
from judge.run import Attempt
from judge.sandbox.facts import Facts, RunLimits
from stress.running.reference import answer
from stress.running.trial import Subject
from stress.search import result as results
from stress.search import search as searching
from stress.search.search import CHANGES, DEPENDS, Result, search
from stress.shrinking.measure import numbers_of

LIMITS = RunLimits(time_limit_s=5.0, memory_mib=512, output_mib=8)
ENDED_WELL = Facts(0, None, 0.1, 0.1, 10.0, 10, None)
Solver = Callable[[list[Scenario]], Iterable[str]]


@pytest.fixture(autouse=True)
def _kept_elsewhere(tmp_path, monkeypatch):
    monkeypatch.setattr(results, "COUNTEREXAMPLES", tmp_path)


def subject(solver: Solver) -> Subject:
    """A program in this process: it prints what the solver returns, and crashes if that raises."""

    def attempts(contents: Iterable[bytes], _limits: RunLimits) -> Iterator[Attempt]:
        for content in contents:
            try:
                output = "\n".join(solver(parse(content))).encode()
            except (ArithmeticError, TimeoutError) as error:
                slow = isinstance(error, TimeoutError)
                yield Attempt(ENDED_WELL, b"", Judgement(Verdict.TLE if slow else Verdict.RTE, "?"))
            else:
                yield Attempt(ENDED_WELL, output, Judgement(Verdict.AC))

    return Subject(attempts, LIMITS)


def searched(solver: Solver, failures: Sequence[CaseResult] = (), seed: int = 1) -> Result:
    return search(subject(solver), failures, seed=seed, drawing_s=0.2)


def found_by(solver: Solver, **options: int) -> Counterexample:
    found = searched(solver, **options).counterexample
    assert found is not None
    return found


def largest(found: Counterexample) -> int:
    return max(map(abs, numbers_of(parse(found.input.encode())[-1])))


@pytest.mark.parametrize(
    ("name", "case", "scenarios", "obstacles", "vertices"),
    [
        ("wrong_answer/strict_touch.py", "", 1, 1, 6),
        ("wrong_answer/containment_forgotten.cpp", "", 1, 1, 6),
        *(
            pytest.param(*one, marks=pytest.mark.slow)
            for one in (
                ("wrong_answer/answer_kept.py", "", 2, 0, 3),
                ("wrong_answer/int32_products.cpp", "secret/static/11-across", 1, 1, 6),
                ("wrong_answer/output_ends_at_collision.py", "", 2, 0, 3),
            )
        ),
        ("run_time_error/standing_still_divides_by_zero.py", "", 1, 0, 3),
    ],
)
def test_submissions_of_the_kit(name, case, scenarios, obstacles, vertices):
    failures = [CaseResult(case_at(DATA, case), Verdict.WA, 0.1, 0.1, 9.0)] if case else []
    submission = read_submission(SUBMISSIONS / name)
    with Pool(Job(submission, load(), without_wall=True, keepers=2), 2) as pool:
        try:
            pool.result(pool.prepare())
        except LanguageError as error:
            pytest.skip(str(error))
        found = search(Subject(pool.attempts, LIMITS), failures, seed=1).counterexample
    assert found is not None
    assert (found.scenarios, found.obstacles, found.vertices) == (scenarios, obstacles, vertices)
    assert largest(found) < 20 or "int32" in name
    assert (DEPENDS in found.steps) == (scenarios > 1)
    assert found.found.startswith("crash: exit status 1: line 19: ZeroDivisionError") == (
        "divides" in name
    )


def test_the_result_says_all_that_a_report_shows(tmp_path):
    found = found_by(lambda scenarios: ["YES" for _ in scenarios])
    assert (found.expected, found.found) == ("NO", "YES")
    assert "obstacle 1" in found.sentence
    assert found.picture.startswith("<svg")
    assert found.file is not None
    assert found.file.parent == tmp_path
    assert found.file.read_text() == found.input == render(parse(found.input.encode())).decode()
    assert found.file.with_suffix(".svg").read_text() == found.picture
    assert "seed 1" in found.steps


def test_equal_seeds_give_equal_results():
    def three_corners(scenarios):
        return ["YES" if len(s.robot) > 4 else answer(s) for s in scenarios]

    first, again = (found_by(three_corners, seed=3) for _ in range(2))
    assert first.input == again.input
    assert first.vertices == 5 + 3


def test_a_right_program_fails_on_nothing():
    outcome = searched(lambda scenarios: map(answer, scenarios))
    assert (outcome.counterexample, outcome.failed) == (None, False)
    assert outcome.answered > 6_000


def test_a_bug_of_large_numbers_is_found_in_a_failing_case_and_its_numbers_shrink():
    def wraps(scenarios):
        for scenario in scenarios:
            (a, b, c) = scenario.robot[:3]
            area = cross(minus(b, a), minus(c, a))
            yield "NO" if area >= 1 << 31 else answer(scenario)

    case = CaseResult(case_at(DATA, "secret/static/05-contacts-huge"), Verdict.WA, 1.0, 1.0, 9.0)
    found = searched(wraps, [case]).counterexample
    assert found is not None
    assert (found.scenarios, found.obstacles, found.vertices) == (1, 0, 3)
    assert largest(found) < 100_000  # 46,341 squared is beyond 2^31


def test_words_that_are_missing_or_too_many_are_an_error_of_one_scenario():
    def no_line(scenarios):
        return [answer(s) for s in scenarios if s.obstacles]

    found = found_by(no_line)
    assert (found.obstacles, found.vertices, found.found) == (0, 3, "nothing")

    def debug(scenarios):
        for scenario in scenarios:
            yield from (["debug"] if len(scenario.robot) > 3 else []) + [answer(scenario)]

    found = found_by(debug)
    assert (found.obstacles, found.vertices) == (0, 4)
    assert found.found == "2 words for 1 scenario, at the end debug YES"


def test_what_is_kept_between_scenarios_is_found_though_each_is_right_alone():
    def kept(scenarios):
        most = 0
        for scenario in scenarios:
            yield "NO" if most > 1 else answer(scenario)
            most = max(most, len(scenario.obstacles))

    found = found_by(kept)
    assert found.scenarios == 2
    first, last = parse(found.input.encode())
    assert (len(first.obstacles), len(last.obstacles)) == (2, 0)
    assert DEPENDS in found.steps
    assert (found.expected, found.found) == ("YES", "NO")


def test_a_crash_in_a_batch_is_cut_out():
    def crashes(scenarios):
        return [str(1 // (len(s.robot) != 5)) and answer(s) for s in scenarios]

    found = found_by(crashes)
    assert (found.obstacles, found.vertices, found.found) == (0, 5, "crash: ?")


def test_a_loop_on_a_small_scenario_is_found_and_slowness_by_size_is_told_at_once():
    def loops(scenarios):
        if any(scenario.move[0] < -2 for scenario in scenarios):
            raise TimeoutError
        return map(answer, scenarios)

    found = found_by(loops)
    (scenario,) = parse(found.input.encode())
    assert (scenario.move, found.vertices) == ((-3, 0), 3)
    assert found.found.startswith("time limit exceeded")

    case = CaseResult(case_at(DATA, "secret/static/39-large-robot"), Verdict.TLE, 6.0, 6.0, 9.0)

    def slow(scenarios):
        if max(scenario.vertices for scenario in scenarios) > 900:
            raise TimeoutError
        return map(answer, scenarios)

    outcome = searched(slow, [case])
    assert (outcome.counterexample, outcome.failed) == (None, True)
    assert outcome.remark == searching.ONLY_SIZE


def test_answers_that_change_are_told():
    count = 0

    def coin(scenarios):
        nonlocal count
        for _ in scenarios:
            count += 1
            yield "NO" if count % 3 else "YES"

    found = found_by(coin)
    assert CHANGES in found.steps
    assert "runs)" in found.found


def test_a_program_that_becomes_right_meanwhile_has_no_counterexample():
    runs = 0

    def recovers(scenarios):
        nonlocal runs
        runs += 1
        return ["YES" if runs < 8 else answer(s) for s in scenarios]

    outcome = searched(recovers)
    assert (outcome.counterexample, outcome.failed, outcome.remark) == (None, True, CHANGES)


def test_what_is_slow_only_for_the_limit_of_the_search_is_not_shown():
    def attempts(contents: Iterable[bytes], limits: RunLimits) -> Iterator[Attempt]:
        for content in contents:
            scenarios = parse(content)
            over = any(s.move == (1, 1) for s in scenarios) and (
                limits != LIMITS or len(scenarios) > 50
            )
            judgement = Judgement(Verdict.TLE if over else Verdict.AC)
            yield Attempt(ENDED_WELL, "\n".join(map(answer, scenarios)).encode(), judgement)

    outcome = search(Subject(attempts, LIMITS), [], seed=1, drawing_s=0.2)
    assert (outcome.counterexample, outcome.failed) == (None, True)
    assert outcome.remark == searching.ONLY_LIMIT


def test_answers_that_depend_on_how_many_scenarios_there_are_do_not_change_from_run_to_run():
    def by_count(scenarios):
        return [answer(s) if len(scenarios) % 2 else "YES" for s in scenarios]

    found = found_by(by_count)
    assert found.scenarios == 2
    assert CHANGES not in found.steps

    def three_or_more(scenarios):
        free = len(scenarios) > 2
        return ["YES" if free else answer(s) for s in scenarios]

    found = found_by(three_or_more)
    assert found.scenarios == 3
    assert searching.DEPENDS_ON_FILE in found.steps
    assert (found.expected, found.found) == ("NO", "YES")
