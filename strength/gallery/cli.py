"""`python -m strength gallery`: the scenes that diagnose, and how well they do."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from gen.scenario import Scenario, render
from judge.diagnosis.asking import Answers
from judge.diagnosis.gallery import GALLERY, Gallery, Scene, load_gallery, load_lessons
from judge.kit.command import Parser, add_jobs
from judge.kit.paths import REFERENCE
from judge.kit.processors import processors
from judge.kit.progress import progress_bar
from judge.kit.text import counted
from judge.kit.trusted import python_command, run_trusted
from judge.problem.declaration import Problem, load
from judge.sandbox.sandbox import Sandbox
from strength.gallery.choose import choose, mutants_of, shortlist
from strength.gallery.measure import Measured, faults, measure, steady_answers
from strength.gallery.pool import TURNS, candidates, disguised
from strength.gallery.programs import Faulty, each, faulty_submissions
from strength.gallery.write import save_answers, save_scenes

GOOD, FAULTS = 0, 1
BATCH = 5_000  # scenarios in a file


def command(arguments: Sequence[str]) -> int:
    """Return 0 if every wrong submission fails enough scenes, else 1. Raises KitError, OSError."""
    parser = Parser(
        prog="python -m strength gallery",
        description="Ask every wrong submission for its answers to the gallery, keep them in "
        "data/gallery/answers.json, and tell how often the first lesson named is the true one, "
        "when the submission itself and its twins are left out.",
    )
    add = parser.add_argument
    add("--choose", action="store_true", help="first choose the scenes anew, from the pool")
    add("--gallery", type=Path, default=GALLERY, metavar="DIR", help="default: data/gallery")
    add_jobs(parser, processors(), "submissions run")
    options = parser.parse_args(arguments)
    problem = load()
    with Sandbox(keepers=options.jobs) as sandbox:
        if options.choose:
            save_scenes(options.gallery, _chosen(problem, options.gallery, sandbox, options.jobs))
            save_answers(options.gallery, {})
        gallery = load_gallery(options.gallery)
        answers = _asked(problem, gallery, sandbox, options.jobs)
    known = steady_answers(answers)
    save_answers(options.gallery, known)
    gallery = Gallery(gallery.lessons, gallery.scenes, known)
    return _report(gallery, measure(gallery, answers))


def _chosen(problem: Problem, directory: Path, sandbox: Sandbox, jobs: int) -> list[Scene]:
    lessons, pool = load_lessons(directory), candidates()
    scenarios = [candidate.scenario for candidate in pool]
    output = run_trusted(REFERENCE.name, python_command(REFERENCE), render(scenarios))
    right = "".join(word[0] for word in output.decode().split())
    answers = _answers(problem, scenarios, sandbox, jobs)
    short = shortlist(pool, right, answers, lessons)
    some = sorted({i for best in short.values() for listed in best.values() for i in listed})
    disguises = [disguised(scenarios[i], turn) for turn in range(TURNS) for i in some]
    mutants = mutants_of(_answers(problem, disguises, sandbox, jobs), some, right)
    return choose(pool, right, short, mutants, lessons)


def _answers(
    problem: Problem, scenarios: Sequence[Scenario], sandbox: Sandbox, jobs: int
) -> dict[str, str]:
    """Return the answers of the wrong submissions, one letter each, where they are in step."""
    parts = [scenarios[i : i + BATCH] for i in range(0, len(scenarios), BATCH)]
    files, counts = list(map(render, parts)), list(map(len, parts))
    names = faulty_submissions(problem)
    answers: dict[str, str] = {}
    with progress_bar(f"answering {counted(len(scenarios), 'scenario')}", len(names)) as bar:

        def answer(faulty: Faulty) -> None:
            given = faulty.answers(files, counts)
            if given is not None:
                answers[faulty.name] = given
            bar.advance()

        each(names, problem, sandbox, jobs, answer)
    return {name: answers[name] for name in names if name in answers}


def _asked(problem: Problem, gallery: Gallery, sandbox: Sandbox, jobs: int) -> dict[str, Answers]:
    names = faulty_submissions(problem)
    answers: dict[str, Answers] = {}
    with progress_bar("answering the gallery", len(names)) as bar:

        def ask(faulty: Faulty) -> None:
            answers[faulty.name] = faulty.asked(gallery)
            bar.advance()

        each(names, problem, sandbox, jobs, ask)
    return {name: answers[name] for name in names}


def _report(gallery: Gallery, measured: Sequence[Measured]) -> int:
    """Print what was measured; return the exit status."""
    caught = [one for one in measured if one.true and (one.wrong or one.named)]
    for one in caught:
        if not one.first_is_true:
            expected = " or ".join(sorted(one.true))
            print(f"{one.submission}: expected {expected} first, found {', '.join(one.named[:3])}")
    true = sum(one.first_is_true for one in caught)
    among = sum(bool(one.true & set(one.named[:3])) for one in caught)
    print(
        f"{counted(len(gallery.scenes), 'scene')}, {counted(len(gallery.lessons), 'lesson')}; "
        f"of {counted(len(caught), 'wrong submission')} that fail, the first lesson named is the "
        f"true one for {true} ({100 * true // max(1, len(caught))} %), one of the first three "
        f"for {among}"
    )
    lines = faults(measured, gallery)
    for line in lines:
        print(line)
    return FAULTS if lines else GOOD
