"""The input validator and the answer validator, as the Kattis formats call them.

Both are programs in Python 3.9 or newer: they read standard input, and exit with 42 if it is
valid, with 43 if not. The sources are in programs/; the rules of `problem.toml` go with them.
"""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path

from export.files import Files
from export.package import Package
from gen.validator import load_rules
from judge.kit.paths import VALIDATOR

PROGRAMS = Path(__file__).with_name("programs")
GROUP_OPTION = "--group"
ANY = ""  # the rules for any file, whatever its group


def input_validator(package: Package) -> Files:
    """Return the files of the input validator: main program, grammar, rules."""
    rules = {ANY: load_rules()} | {group.name: load_rules(group.name) for group in package.groups}
    lines = [f"    {name!r}: {asdict(each)!r},\n" for name, each in rules.items()]
    files = Files()
    files.add("main.py", PROGRAMS / "validate_input.py")
    files.add("grammar.py", VALIDATOR)
    files.add("rules.py", "".join(["RULES = {\n", *lines, "}\n"]))
    return files


def answer_validator() -> Files:
    """Return the file of the answer validator."""
    files = Files()
    files.add("main.py", PROGRAMS / "validate_answer.py")
    return files
