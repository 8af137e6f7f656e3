#!/usr/bin/python3 -IS
"""Checker for CMS: the tokens of the output are those of the answer, in either letter case.

    checker INPUT ANSWER OUTPUT

Prints the share of the points, 1.0 or 0.0. CMS shows the first line of standard error to the
contestant in their language, and the rest to the judges.
"""

import sys
from pathlib import Path


def main() -> None:
    """Compare the output with the answer; one token answers one scenario."""
    answer, output = (Path(name).read_bytes().lower().split() for name in sys.argv[2:4])
    if output == answer:
        print("1.0")
        print("translate:success", file=sys.stderr)
        return
    first = 0
    while answer[first : first + 1] == output[first : first + 1]:
        first += 1
    print("0.0")
    print("translate:wrong", file=sys.stderr)
    print(f"ADMIN_MESSAGE: scenario {first + 1}: {len(output)} answers found", file=sys.stderr)


main()
