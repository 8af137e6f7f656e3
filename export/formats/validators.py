"""The input validator and the answer validator, as the Kattis formats call them.

Both are single programs in Python 3.9 or newer: called with the input on standard input, they
exit with 42 if it is valid, with 43 if not. The rules of `problem.toml` are written into them.
"""

from __future__ import annotations

from dataclasses import asdict

from export.files import Files
from export.package import Package
from gen.validator import load_rules
from judge.kit.paths import VALIDATOR

GROUP_OPTION = "--group"

_INPUT_MAIN = '''"""Input validator: exit status 42 if standard input is valid, 43 if not.

    python3 main.py [--group NAME] < FILE

`grammar.py` beside it does the work. The rules are those of the problem's declaration.
"""

import sys

from grammar import InputError, Rules, validate

VALID, INVALID = 42, 43
RULES = {rules}


def main(arguments):
    group = arguments[arguments.index("--group") + 1] if "--group" in arguments else None
    try:
        validate(sys.stdin.buffer, Rules(**RULES[group]))
    except InputError as fault:
        print(f"line {{fault.line}}: {{fault.reason}}", file=sys.stderr)
        return INVALID
    return VALID


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
'''

_ANSWER_MAIN = '''"""Answer validator: exit status 42 if standard input is one YES or NO a line, 43 if not.

    python3 main.py INPUT < ANSWER

The number of lines must be the number of scenarios in INPUT.
"""

import sys

VALID, INVALID = 42, 43


def main(arguments):
    with open(arguments[0], "rb") as file:
        scenarios = int(file.readline())
    content = sys.stdin.buffer.read()
    lines = content.split(b"\\n")
    if lines.pop() != b"":
        return refuse("expected a newline at the end")
    for number, line in enumerate(lines, 1):
        if line not in (b"YES", b"NO"):
            return refuse(f"line {number}: expected YES or NO, found {line[:20]!r}")
    if len(lines) != scenarios:
        return refuse(f"expected {scenarios} lines, found {len(lines)}")
    return VALID


def refuse(reason):
    print(reason, file=sys.stderr)
    return INVALID


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
'''


def input_validator(package: Package) -> Files:
    """Return the files of the input validator: `main.py` and the grammar."""
    names: list[str | None] = [None, *(group.name for group in package.groups)]
    lines = "".join(f"    {name!r}: {asdict(load_rules(name))!r},\n" for name in names)
    files = Files()
    files.add("main.py", _INPUT_MAIN.format(rules=f"{{\n{lines}}}"))
    files.add("grammar.py", VALIDATOR)
    return files


def answer_validator() -> Files:
    """Return the file of the answer validator."""
    files = Files()
    files.add("main.py", _ANSWER_MAIN)
    return files
