"""How a program is asked: in one run, lesson by lesson, or scene by scene."""

import pytest

from judge.decide import Judgement
from judge.diagnosis.asking import CHECKED_ALONE, STALLS, Steadiness, ask
from judge.diagnosis.diagnose import read
from judge.diagnosis.gallery import NO_ANSWER, NOT_ASKED, Gallery, Lesson, Scene
from judge.problem.verdict import Verdict
from judge.run import Attempt
from judge.sandbox.facts import Facts, RunLimits

FACTS = Facts(0, None, 0.01, 0.02, 5.0, 10, None)
LIMITS = RunLimits(5.0, 512, 8)
SHAPES = ("answers", "chance", "separate-scenarios", "one-line-each", "exit-status")
TAUGHT = ("touch", "no-obstacles", "standing-still", "inside")


def scene(lesson, number, *, answer="NO", obstacles=1, move="1 0"):
    """Return a scene whose input is only as true as the tests need: its number is a coordinate."""
    text = f"3 {obstacles}\n{move}\n{number} 0\n"
    return Scene(f"{lesson}-{number}", lesson, answer, text)


SCENES = (
    scene("no-obstacles", 1, answer="YES", obstacles=0),
    scene("no-obstacles", 2, answer="YES", obstacles=0),
    scene("touch", 3),
    scene("touch", 4),
    scene("standing-still", 5, move="0 0"),
    scene("inside", 6),
    scene("inside", 7, answer="YES"),
    scene("inside", 8, obstacles=2),
)
GALLERY = Gallery({name: Lesson(f"About {name}.") for name in SHAPES + TAUGHT}, SCENES, {})


class Program:
    """A program in Python, run without a sandbox: a function from scenes' fields to an output."""

    def __init__(self, answers):
        self.answers = answers
        self.runs = 0

    def attempts(self, contents, limits):
        for content in contents:
            self.runs += 1
            words = content.decode().split()
            rows = [words[1 + 6 * i : 7 + 6 * i] for i in range(int(words[0]))]
            yield self.run(rows, limits)

    def run(self, rows, _limits):
        try:
            output = self.answers(rows)
        except ZeroDivisionError:
            return Attempt(FACTS, b"", Judgement(Verdict.RTE, "exit status 1"))
        except TimeoutError:
            return Attempt(FACTS, b"", Judgement(Verdict.TLE, "slow"))
        return Attempt(FACTS, output.encode(), Judgement(Verdict.AC))


def right(row):
    number = int(row[4])
    return SCENES[number - 1].answer


def asked(answers):
    """Ask a program, given as a function of all rows of a file."""
    program = Program(answers)
    return ask(GALLERY, program.attempts, LIMITS), program


def lines(answers):
    return "".join(f"{answer}\n" for answer in answers)


def named(answers):
    return [lesson.id for lesson in read(GALLERY, answers).lessons]


def test_a_program_in_step_is_asked_once_and_its_wrong_scenes_again():
    def flips_touch(rows):
        return lines("YES" if row[4] in "34" else right(row) for row in rows)

    answers, program = asked(flips_touch)
    assert (answers.letters, answers.in_step) == ("YYYYNNYN", True)
    assert answers.steadiness is Steadiness.STEADY
    assert program.runs == 1 + 2
    assert named(answers) == ["touch"]
    assert read(GALLERY, answers).wrong == 2


def test_a_right_program_is_asked_once_and_misses_nothing():
    answers, program = asked(lambda rows: lines(map(right, rows)))
    assert program.runs == 1
    assert read(GALLERY, answers).lessons == ()
    assert read(GALLERY, answers).remark == ""


def test_a_crash_on_few_scenes_is_found_and_the_others_are_answered():
    def crashes(rows):
        return lines("NO" if 1 // int(row[1]) < 0 else right(row) for row in rows)

    answers, program = asked(crashes)
    assert answers.letters == f"{NO_ANSWER * 2}NNNNYN"
    assert not answers.in_step
    assert named(answers) == ["no-obstacles"]
    assert program.runs == 1 + CHECKED_ALONE + len(TAUGHT) + 2


def test_a_program_that_keeps_its_answer_depends_on_the_scenes_before():
    def keeps(rows):
        found = []
        for row in rows:
            found.append("NO" if "NO" in found else right(row))
        return lines(found)

    answers, _program = asked(keeps)
    assert answers.steadiness is Steadiness.DEPENDS
    assert answers.letters == GALLERY.expected
    assert named(answers) == ["separate-scenarios"]


def test_a_program_that_answers_by_chance_is_told_so_and_nothing_else():
    draws = iter(range(1_000))

    def tosses(rows):
        return lines("YES" if next(draws) % 3 else "NO" for _row in rows)

    answers, _program = asked(tosses)
    assert answers.steadiness is Steadiness.CHANCE
    assert named(answers) == ["chance"]


@pytest.mark.parametrize(
    ("answers", "remark"),
    [
        (lambda _rows: "", "It prints nothing."),
        (lambda rows: right(rows[0]), "It prints 1 answer for 16 scenarios: the first number"),
        (lambda rows: lines(right(r) for r in rows if r[1] != "0"), "those with k = 0 get none"),
        (lambda rows: lines(right(r) for r in rows for _ in range(2)), "get more than one"),
        (lambda rows: lines(f"Case: {right(r)}" for r in rows), "other words, such as 'Case:'"),
        (lambda rows: lines("1" if right(r) == "YES" else "0" for r in rows), "such as '1'"),
        (lambda rows: lines(map(right, rows)).partition("NO")[0] + "NO", "ends after its first NO"),
    ],
)
def test_output_out_of_step_is_described(answers, remark):
    found, _program = asked(answers)
    diagnosis = read(GALLERY, found)
    assert remark in diagnosis.remark
    assert "one-line-each" in named(found)


def test_an_endless_program_is_not_asked_forever():
    def hangs(_rows):
        raise TimeoutError

    answers, program = asked(hangs)
    assert program.runs == 1 + STALLS
    assert set(answers.letters) == {NOT_ASKED}
    assert not answers.in_step


def test_a_program_that_never_answers_is_told_that_and_no_lesson():
    def crashes(_rows):
        raise ZeroDivisionError

    answers, program = asked(crashes)
    assert program.runs == 1 + CHECKED_ALONE
    diagnosis = read(GALLERY, answers)
    assert diagnosis.lessons == ()
    assert diagnosis.remark == "It answers no scene of the gallery, not even alone: exit status 1"
    assert diagnosis.wrong == len(SCENES)


def test_answers_that_are_all_swapped_miss_the_meaning_of_the_words():
    swapped = {"YES": "NO", "NO": "YES"}
    answers, _program = asked(lambda rows: lines(swapped[right(row)] for row in rows))
    assert named(answers) == ["answers"]
    answers, _program = asked(lambda rows: lines("YES" for _row in rows))
    assert named(answers) == ["answers"]


def test_right_answers_before_a_crash_leave_the_exit_status():
    class Crashing(Program):
        def run(self, rows, _limits):
            output = lines(map(right, rows)).encode()
            return Attempt(FACTS, output, Judgement(Verdict.RTE, "exit status 3"))

    program = Crashing(None)
    answers = ask(GALLERY, program.attempts, LIMITS)
    assert named(answers)[0] == "exit-status"
