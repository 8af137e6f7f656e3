"""On the terminal: why the program is not accepted. The first failure, lessons, a counterexample.

Texts to paste stand without indentation and are never wrapped.
"""

from __future__ import annotations

from collections.abc import Iterator

from rich.console import Console
from rich.text import Text

from judge.explanation import Counterexample, Diagnosis, FailedScene
from judge.kit.text import printable_name
from judge.problem.verdict import Verdict
from judge.reports.slowness import TITLE as SLOW
from judge.reports.slowness import slow_sentences
from judge.reports.words import (
    SHORT_LINES,
    as_input,
    failing_scenario,
    headline,
    last_lines,
    like_sentence,
    missed_title,
    page_of,
    see_it,
    shown,
    size_of,
    wrong_scenes,
)
from judge.results import CaseResult, Judging

FEW_SCENES = 5
REMARK = 600  # characters: it may name some coordinates
FEW_LESSONS = 3
TITLE = "bold"


def print_explained(
    console: Console, judging: Judging, verdict: Text, *, explain: bool, verbose: bool
) -> None:
    """Print the first failure, the missed lessons and the counterexample, as far as there are any.

    verdict: of the first failure, as it is shown. explain: all missed lessons, with their
    scenes, not only the most telling. verbose: all that is kept of standard error.
    """
    failure, example = judging.first_failure, judging.counterexample
    if failure is not None:
        console.print(
            Text.assemble("first failure: ", verdict, f" on {headline(failure)}"), soft_wrap=True
        )
        _print(console, _failure_lines(failure, smaller=example is not None, verbose=verbose))
    if judging.diagnosis is not None:
        _print(console, _diagnosis_lines(judging.diagnosis, explain=explain))
    if judging.slowness is not None:
        console.print(Text(f"{SLOW}:", style=TITLE))
        _print(console, (f"  {sentence}" for sentence in slow_sentences(judging.slowness)))
    if example is not None:
        print_counterexample(console, example)
    elif judging.unexplained:
        console.print(Text(printable_name(judging.unexplained)), soft_wrap=True)


def print_counterexample(console: Console, example: Counterexample) -> None:
    """Print a counterexample: the input to paste, expected and found, why, where it is kept."""
    _print(console, _example_lines(example))


def _print(console: Console, lines: Iterator[str | Text]) -> None:
    for line in lines:
        console.print(line if isinstance(line, Text) else Text(line), soft_wrap=True)


def _failure_lines(failure: CaseResult, *, smaller: bool, verbose: bool) -> Iterator[str | Text]:
    """Yield the files, standard error, the scenario. smaller: a smaller one follows, to be seen."""
    if not failure.withheld:
        yield f"  input  {shown(failure.case.input)}"
        yield f"  answer {shown(failure.case.answer)}"
    if failure.stderr and (verbose or failure.verdict is Verdict.RTE):
        every = failure.stderr.splitlines()
        some = every if verbose else last_lines(failure.stderr)
        cut = " (the end; --verbose shows more)" if len(some) < len(every) else ""
        yield f"  standard error{cut}:"
        yield from (f"    {line}" for line in some)
    scenario = failing_scenario(failure)
    if scenario is None or failure.mismatch is None:
        return
    if not smaller and (command := see_it(failure.case.input, failure.mismatch.scenario)):
        yield f"  see it {command}"
    if len(scenario) <= SHORT_LINES:
        yield f"  scenario {failure.mismatch.scenario} as an input of its own:"
        yield as_input(scenario)


def _diagnosis_lines(diagnosis: Diagnosis, *, explain: bool) -> Iterator[str | Text]:
    lessons = diagnosis.lessons if explain else diagnosis.lessons[:FEW_LESSONS]
    if lessons:
        yield Text(f"{missed_title(diagnosis)}:", style=TITLE)
    for number, lesson in enumerate(lessons, 1):
        yield f"  {number}. {printable_name(lesson.sentence)}"
        if explain and lesson.scenes:
            some = ", ".join(map(printable_name, lesson.scenes[:FEW_SCENES]))
            more = len(lesson.scenes) - FEW_SCENES
            rest = f" and {more} more" if more > 0 else ""
            yield Text(f"     scenes: {some}{rest}", style="dim")
            if lesson.scene is not None:
                yield from _scene_lines(lesson.scene)
            shown_scene = lesson.scene.name if lesson.scene else lesson.scenes[0]
            yield Text(f"     play with it: {page_of(shown_scene)}", style="dim")
    if more := len(diagnosis.lessons) - len(lessons):
        yield Text(f"  ({more} more: --explain)", style="dim")
    if lessons and any(lesson.scenes for lesson in lessons):
        yield Text(f"  {wrong_scenes(diagnosis)}", style="dim")
    for sentence in (like_sentence(diagnosis), printable_name(diagnosis.remark, REMARK)):
        if sentence:
            yield f"  {sentence}" if lessons else sentence


def _scene_lines(scene: FailedScene) -> Iterator[str | Text]:
    """Yield a scene of a missed lesson: its input if it is short, why, where it can be seen."""
    lines = scene.input.splitlines()
    yield f"     {printable_name(scene.name)}:"
    if len(lines) <= SHORT_LINES + 1:  # the first says that there is one scenario
        yield "\n".join(map(printable_name, lines))
    elif scene.file is not None:
        yield f"     input {shown(scene.file)}"
    yield f"     expected {printable_name(scene.expected)}, found {printable_name(scene.found)}"
    if scene.sentence:
        yield f"     {printable_name(scene.sentence)}"
    if scene.file is not None:
        yield f"     picture {shown(scene.file.with_suffix('.svg'))}"


def _example_lines(example: Counterexample) -> Iterator[str | Text]:
    yield Text(f"a smallest input that it gets wrong ({size_of(example)}):", style=TITLE)
    yield "\n".join(printable_name(line) for line in example.input.splitlines())
    yield f"  expected {printable_name(example.expected)}, found {printable_name(example.found)}"
    if example.sentence:
        yield f"  {printable_name(example.sentence)}"
    if example.file is not None:
        yield f"  input   {shown(example.file)}"
        picture = example.file.with_suffix(".svg")
        if picture.is_file():
            yield f"  picture {shown(picture)}"
        else:
            yield f"  see it  {see_it(example.file, example.scenarios)}"
    for step in (*example.steps, f"found in {example.seconds:.1f} s"):
        yield Text(f"  {printable_name(step)}", style="dim")
