"""Input validator: exit status 42 if standard input is valid, 43 if not.

    python3 main.py [--group NAME] < FILE

`grammar.py` beside it reads the input, and `rules.py` holds the limits: for any file, and for
each group. Python 3.9 or newer.
"""

import sys

from grammar import InputError, Rules, validate
from rules import RULES

VALID, INVALID = 42, 43


def main(arguments):
    group = arguments[1] if arguments[:1] == ["--group"] else ""
    try:
        validate(sys.stdin.buffer, Rules(**RULES[group]))
    except InputError as fault:
        print(f"line {fault.line}: {fault.reason}", file=sys.stderr)
        return INVALID
    return VALID


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
