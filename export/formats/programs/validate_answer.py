"""Answer validator: exit status 42 if standard input has one answer a line, 43 if not.

    python3 main.py INPUT < ANSWER

An answer is YES or NO. INPUT says how many there must be. Python 3.9 or newer.
"""

import sys

VALID, INVALID = 42, 43


def main(arguments):
    with open(arguments[0], "rb") as file:
        scenarios = int(file.readline())
    fault = find_fault(sys.stdin.buffer.read().split(b"\n"), scenarios)
    if fault:
        print(fault, file=sys.stderr)
    return INVALID if fault else VALID


def find_fault(lines, scenarios):
    """Return what is wrong with the lines, the last of which must be empty; "" if nothing is."""
    if lines.pop() != b"":
        return "expected a newline at the end"
    for number, line in enumerate(lines, 1):
        if line not in (b"YES", b"NO"):
            return f"line {number}: expected YES or NO, found {line[:20]!r}"
    if len(lines) != scenarios:
        return f"expected {scenarios} lines, found {len(lines)}"
    return ""


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
