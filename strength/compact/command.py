"""The part of `python -m strength --compact` that follows the kill matrix."""

from __future__ import annotations

from judge.kit.console import PlainConsole
from judge.machine import kept_scale
from judge.problem.compact import save_compact
from judge.problem.data import Data
from judge.problem.declaration import Problem
from strength.compact.choose import choose
from strength.compact.show import print_cost, reference_seconds
from strength.table import Matrix


def write(matrix: Matrix, data: Data, problem: Problem) -> None:
    """Choose the cases, write `compact.json`, and print what that costs and saves.

    Raises KitError, OSError.
    """
    scale = kept_scale(problem)
    seconds = reference_seconds(data.chosen, problem, scale.factor if scale else 1.0)
    chosen = choose(matrix, problem, data.manifest.cases, seconds)
    save_compact(data.directory, chosen)
    print_cost(PlainConsole(), matrix, problem, chosen, seconds)
