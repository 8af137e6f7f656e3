"""The plan: every test case, as data. Adding one moves no other (see `gen.seeds`)."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DATA = ROOT / "data"
USER_CASES = "cases.toml"  # below data/: cases that users added, kept by every build

HAND_MADE = ""  # stands for the family of a case whose .in is written by hand


class PlanError(Exception):
    """The list of added cases cannot be used; one clear line."""


@dataclass(frozen=True)
class Case:
    """One test case: where it lies, and how it is made.

    repeat: tells apart cases of equal family and parameters; part of the seed.
    """

    group: str
    name: str
    family: str = HAND_MADE
    parameters: Mapping[str, int | str] = field(default_factory=dict)
    repeat: int = 1

    @property
    def path(self) -> str:
        """The case's path below data/, without ending."""
        return (
            f"sample/{self.name}" if self.group == "sample" else f"secret/{self.group}/{self.name}"
        )


HUGE = {"reach": 90_000_000, "size": 90_000_000, "corner": 1}

PLANNED = (
    Case("sample", "01-first"),
    Case("sample", "02-sweep"),
    Case("sample", "03-touch"),
    Case("sample", "04-notch"),
    # static: do two convex polygons meet?
    Case("static", "01-tiny", "tiny", {"far": 0}),
    Case("static", "02-contacts", "contacts", {"move": "zero"}),
    Case("static", "03-scenes", "random_scenes", {"move": "zero"}),
    Case("static", "04-contacts-huge", "contacts", {"move": "zero", **HUGE}),
    Case("static", "05-scenes-huge", "random_scenes", {"move": "zero", **HUGE}),
    # small: everything that the brute force can still agree to
    Case("small", "01-tiny", "tiny"),
    Case("small", "02-contacts", "contacts"),
    Case("small", "03-scenes", "random_scenes"),
    Case("small", "04-contacts-huge", "contacts", {"far": 90_000_000, **HUGE}),
    # large: sizes, but little k * m
    Case(
        "large",
        "01-largest",
        "hugging",
        {"scenarios": 1, "m": 250_000, "obstacles": 4, "n": 62_500, "deciding": "none"},
    ),
    Case("large", "02-tiny", "tiny", {"scenarios": 100_000, "vertices": 500_000, "empty": 34}),
    # many: one unit decides, wherever one looks
    Case(
        "many",
        "01-triangles",
        "hugging",
        {"scenarios": 1, "m": 250_000, "obstacles": 83_333, "flat": 50, "deciding": "last"},
    ),
)


def user_cases(data: Path = DATA) -> tuple[Case, ...]:
    """Return the cases that users added. PlanError if their list cannot be used."""
    path = data / USER_CASES
    try:
        table = tomllib.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return ()
    except (OSError, ValueError) as error:
        raise PlanError(f"{path}: cannot be used: {error}") from None
    try:
        return tuple(Case(**entry) for entry in table["case"])
    except (TypeError, KeyError) as error:
        raise PlanError(f"{path}: expected [[case]] tables of a case's fields: {error}") from None


def all_cases(data: Path = DATA) -> tuple[Case, ...]:
    """Return the planned cases and those that users added, in order of groups."""
    return PLANNED + user_cases(data)


def user_case_entry(case: Case) -> str:
    """Return the lines of `cases.toml` that describe a case."""
    values = ", ".join(
        f"{name} = {_toml(value)}" for name, value in sorted(case.parameters.items())
    )
    return (
        f"\n[[case]]\ngroup = {_toml(case.group)}\nname = {_toml(case.name)}\n"
        f"family = {_toml(case.family)}\nparameters = {{ {values} }}\nrepeat = {case.repeat}\n"
    )


def _toml(value: int | str) -> str:
    """Return an integer or a plain word (no quotes, no control characters) as TOML."""
    return str(value) if isinstance(value, int) else f'"{value}"'
