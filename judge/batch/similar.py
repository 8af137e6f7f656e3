"""Which programs are nearly identical: a note for whoever grades, and never an accusation.

A source text becomes tokens (names, numbers, operators, strings) without comments and white
space. Its shingles are the sets of K tokens in a row. Two programs are nearly identical if the
number of their common shingles is at least LEAST of the number of all their shingles (the
Jaccard index). Two students can reach that without knowing each other, from the same lecture
notes. Names are compared as they are, so a program with renamed variables is not found.
Source: Broder, On the resemblance and containment of documents (1997).
"""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence

from judge.languages.table import Language

K = 5
LEAST = 0.8
FEWEST_TOKENS = 40  # a shorter program is like many others

Shingles = frozenset[int]

_HASH = r"\#[^\n]*"
_SLASHES = r"//[^\n]*|/\*.*?(?:\*/|\Z)"
_WORDS = r"""
    "(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])*' | \w+ | [-+*/%&|^<>=!]=? | [^\s\w]
"""


def shingles(source: bytes, language: Language) -> Shingles:
    """Return the shingles of a source text, as hashes; none of a short text. O(length)."""
    comment = _HASH if language.name.startswith("Py") else _SLASHES
    pattern = re.compile(f"(?P<comment>{comment})|{_WORDS}", re.VERBOSE | re.DOTALL)
    found = pattern.finditer(source.decode("utf-8", "replace"))
    tokens = [match[0] for match in found if match["comment"] is None]
    if len(tokens) < FEWEST_TOKENS:
        return frozenset()
    return frozenset(hash(tuple(tokens[i : i + K])) for i in range(len(tokens) - K + 1))


def nearly_identical(programs: Sequence[Shingles]) -> Mapping[int, list[tuple[float, int]]]:
    """Return for each program those that are nearly identical, closest first.

    programs: by number. Result: pairs (share of common shingles, number). Exact, and faster than
    all pairs: ordered by rarity, two sets with a Jaccard index of at least LEAST have a common
    shingle among the first 1 + (1 - LEAST) * size of each, so only such pairs are compared.
    Source: Bayardo, Ma, Srikant, Scaling up all pairs similarity search (2007).
    """
    rarity = Counter(shingle for program in programs for shingle in program)
    holders: dict[int, list[int]] = defaultdict(list)
    found: dict[int, list[tuple[float, int]]] = defaultdict(list)
    for number, program in enumerate(programs):
        ordered = sorted(program, key=lambda shingle: (rarity[shingle], shingle))
        prefix = ordered[: int((1 - LEAST) * len(ordered)) + 1]
        for other in {other for shingle in prefix for other in holders[shingle]}:
            common = len(program & programs[other])
            share = common / (len(program) + len(programs[other]) - common)
            if share >= LEAST:
                found[number].append((share, other))
                found[other].append((share, number))
        for shingle in prefix:
            holders[shingle].append(number)
    return {
        number: sorted(near, key=lambda each: (-each[0], each[1])) for number, near in found.items()
    }


def _closest_first(near: tuple[float, int]) -> tuple[float, int]:
    return -near[0], near[1]
