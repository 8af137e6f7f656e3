"""From a failing file to what a report shows: the counterexample, kept in files."""

from __future__ import annotations

import hashlib
from pathlib import Path

from gen.answers import agreed
from gen.scenario import render
from judge.explanation import Counterexample
from judge.kit.files import write_whole
from judge.kit.paths import BUILD
from judge.problem.verdict import Verdict
from pictures.explain import explain_picture
from pictures.special import special_facts
from pictures.words import sentence
from stress.running.trial import Trial

COUNTEREXAMPLES = BUILD / "counterexamples"


def counterexample(
    trial: Trial, found: str, seconds: float, steps: tuple[str, ...]
) -> Counterexample:
    """Return a failing file as a counterexample; keep it, and its picture beside it.

    The expected answer is that of two methods. Raises DisagreementError if they differ,
    ProgramError, OSError.
    """
    content = render(trial.scenarios)
    expected = agreed(content, trial.scenarios).decode().split()
    answer, scenario = expected[trial.index], trial.scenarios[trial.index]
    which = f"scenario {trial.index + 1} of {len(expected)}" if expected[1:] else ""
    picture = explain_picture(scenario, answer=answer, found=found, title=which)
    why = sentence(scenario)
    file = keep(content, picture, f"shrunk-{hashlib.sha256(content).hexdigest()[:12]}")
    return Counterexample(
        input=content.decode(),
        expected=answer,
        found=found,
        scenarios=len(trial.scenarios),
        obstacles=len(scenario.obstacles),
        vertices=scenario.vertices,
        sentence=f"{which.capitalize()}: {why}" if which else why,
        picture=picture,
        file=file,
        seconds=seconds,
        steps=steps,
        in_step=trial.in_step or trial.verdict is not Verdict.WA,
        special=special_facts(scenario),
    )


def keep(content: bytes, picture: str, name: str) -> Path:
    """Write an input below build/counterexamples/, and its picture beside it; return its path.

    name: without an ending; different inputs need different names. Raises OSError.
    """
    path = COUNTEREXAMPLES / f"{name}.in"
    write_whole(path, content, parents=True)
    write_whole(path.with_suffix(".svg"), picture.encode())
    return path
