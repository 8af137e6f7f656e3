"""What the reports for people say in the same words: the terminal's and the page's."""

from __future__ import annotations

import shlex
from pathlib import Path
from urllib.parse import quote

from judge.explanation import Counterexample, Diagnosis
from judge.kit.paths import EXPLORER, ROOT
from judge.kit.text import ELLIPSIS, counted, printable_name
from judge.machine import UNCALIBRATED
from judge.problem.scenarios import scenario_lines
from judge.problem.verdict import Verdict
from judge.results import CaseResult, GroupResult, Judging

PICTURES = ROOT / "pictures"
ANSWERS = ("YES", "NO")
SHORT_LINES = 12  # a scenario of so many lines is shown itself
FOUND_CHARS = 80  # of what was found instead of the answer
LAST_LINES = 6  # of standard error


def shown(path: Path) -> str:
    """Return a path to type here: relative if it is below the current directory."""
    here = Path.cwd()
    return printable_name(str(path.relative_to(here) if path.is_relative_to(here) else path))


def see_it(file: Path, scenario: int) -> str:
    """Return the command that draws a scenario; it works in any directory and any shell.

    Empty in a kit for students, which cannot draw.
    """
    if not PICTURES.is_dir():
        return ""
    command = ["python3", PICTURES, "show", file.absolute(), scenario, "-o", "scene.svg"]
    return shlex.join(printable_name(str(word)) for word in command)


def failing_scenario(failure: CaseResult) -> list[str] | None:
    """Return the lines of the scenario that was answered wrongly.

    None where to look at it does not help: nothing but YES for NO or NO for YES is about one
    scenario, and not every input is one of this problem.
    """
    found = failure.mismatch
    if found is None or failure.withheld:
        return None
    if not all(str(answer).upper() in ANSWERS for answer in (found.expected, found.found)):
        return None
    return scenario_lines(failure.case.input, found.scenario)


def as_input(scenario: list[str]) -> str:
    """Return the text of an input file that holds only this scenario."""
    return "\n".join(["1", *scenario])


def headline(failure: CaseResult) -> str:
    """Return where the first failure is, and what it is: `secret/small/01: scenario 3: ...`."""
    message = failure.message.partition("\n")[0]
    return f"{failure.case.name}: {message}" if message else failure.case.name


def last_lines(stderr: str, most: int = LAST_LINES) -> list[str]:
    """Return the last lines of standard error."""
    return stderr.splitlines()[-most:]


def page_of(scene: str) -> str:
    """Return the address of a gallery scene in the explorer, for a browser on this machine."""
    return f"{EXPLORER.as_uri()}#gallery={quote(scene)}"


def missed_title(diagnosis: Diagnosis) -> str:
    """Return the title over the missed lessons: sure only if a known program answers alike."""
    return "what it misses" if diagnosis.like else "what it probably misses, most likely first"


def wrong_scenes(diagnosis: Diagnosis) -> str:
    """Return how many scenes of the gallery are answered wrongly, as a sentence."""
    scenes = f"{counted(diagnosis.scenes, 'tiny scene')} of the gallery"
    if diagnosis.wrong == 0:
        return f"each of the {scenes}, asked alone, gets the right answer"
    return f"it answers {diagnosis.wrong} of the {scenes} wrongly"


def like_sentence(diagnosis: Diagnosis) -> str:
    """Return which known program it answers like; empty if there is none."""
    if diagnosis.like is None:
        return ""
    bug = printable_name(diagnosis.like.bug)
    return f"it answers every gallery scene exactly like a program that {bug}"


def first_of(found: str) -> str:
    """Return the beginning of what a program printed or how it crashed, to be shown large."""
    line = found.partition("\n")[0]
    return line if len(line) <= FOUND_CHARS else f"{line[:FOUND_CHARS]}{ELLIPSIS}"


def size_of(example: Counterexample) -> str:
    """Return how small a counterexample is: `1 obstacle, 7 vertices`."""
    size = f"{counted(example.obstacles, 'obstacle')}, {example.vertices} vertices"
    if example.scenarios > 1:
        size += f"; the last of {example.scenarios} scenarios, which it needs to fail"
    return size


def count_of(group: GroupResult) -> str:
    """Return `47`, or `1 of 47` if not all of the group's chosen cases were run."""
    ran = sum(result.verdict is not None for result in group.cases)
    every = len(group.cases)
    return str(every) if ran == every else f"{ran} of {every}"


def limits_line(judging: Judging) -> str:
    """Return the limits that held, and why."""
    limits = f"{judging.time_limit_s:.2f} s of CPU time, {judging.memory_mib} MiB"
    scale = judging.scale
    if scale is not None:
        return (
            f"{limits}; {judging.declared_s:g} s declared, machine scale {scale.factor:.2f} "
            f"({scale.source})"
        )
    if judging.limit_given:
        return f"{limits}; time limit as asked for ({judging.declared_s:g} s declared)"
    if any(result.verdict is Verdict.TLE for result in judging.cases):
        return f"{limits}; {UNCALIBRATED}"
    return limits


def wall_line(judging: Judging) -> str:
    """Return what the wall keeps, or what its lack means."""
    if judging.wall is None:
        return (
            "there was no wall: the program could read the answers, and read, change and send "
            "whatever you can"
        )
    return f"{judging.wall}: no network, no files but its own, no processes but its own"


def changed_line(judging: Judging) -> str:
    """Return how many verdicts a repeated run changed; empty for none."""
    if not judging.changed:
        return ""
    many = f"{len(judging.changed)} verdicts" if judging.changed[1:] else "1 verdict"
    return f"{many} changed when the run was repeated under this slower machine's limit"
