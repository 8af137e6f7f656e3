"""What the output says before any answer is compared: its words, and how many there are. Pure."""

from __future__ import annotations

import re
from collections.abc import Sequence

from judge.kit.text import counted, printable

ANSWER = re.compile(rb"yes|no", re.IGNORECASE)
PAIRS_OF_WORDS = ((b"1", b"0"), (b"0", b"1"), (b"true", b"false"), (b"y", b"n"))


def letters(output: bytes) -> str:
    """Return the answers in an output, one letter Y or N each; other words are skipped.

    >>> letters(b"Case #1: yes NO")
    'YN'
    """
    return "".join(chr(w[0]) for w in output.split() if ANSWER.fullmatch(w)).upper()


def has_other_words(output: bytes) -> bool:
    """Tell whether an output has words other than YES and NO."""
    return not all(ANSWER.fullmatch(word) for word in output.split())


def remark_on(output: bytes, expected: str, obstacles: Sequence[int]) -> str:
    """Return a sentence on an output that does not have one answer for each scenario.

    expected: the right answers, one letter each. obstacles: how many each scenario has.
    Empty if it is as it should be.
    """
    words = output.split()
    scenarios = len(expected)
    if not words:
        return "It prints nothing."
    if has_other_words(output):
        return _on_words(words, scenarios)
    found = letters(output)
    if len(found) == scenarios:
        return ""
    answers = f"It prints {counted(len(found), 'answer')} for {counted(scenarios, 'scenario')}"
    if len(found) == 1:
        return f"{answers}: the first number of the input, t, says how many there are."
    if found == "".join(e for e, k in zip(expected, obstacles, strict=True) if k):
        return f"{answers}: those with k = 0 get none."
    if len(found) == sum(obstacles):
        return f"{answers}: one for each obstacle, but each scenario gets only one."
    if len(found) < scenarios:
        if expected.startswith(found[:-1]) and found.endswith("N") and "N" not in found[:-1]:
            return f"{answers}: it ends after its first NO."
        return f"{answers}: some scenarios get none."
    return f"{answers}: some scenarios get more than one."


def _on_words(words: Sequence[bytes], scenarios: int) -> str:
    """Return a sentence on an output that has other words than YES and NO."""
    lower = [word.lower() for word in words]
    for yes, no in PAIRS_OF_WORDS:
        if len(words) == scenarios and set(lower) <= {yes, no}:
            shown = f"{printable(words[0])!r}"
            return f"It prints other words than YES and NO, such as {shown}."
    other = next(word for word in words if not ANSWER.fullmatch(word))
    answers = sum(ANSWER.fullmatch(word) is not None for word in words)
    if answers == scenarios:
        return f"Besides the answers it prints other words, such as {printable(other)!r}."
    return f"It prints other words than YES and NO, such as {printable(other)!r}."
