"""Which parts of a list to try alone, and which to leave out."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

MOST_PARTS = 64


def parts(n: int, least: int = 0) -> Iterator[list[int]]:
    """Yield lists of indices of 0..n-1, in order, that keep some of them, at least `least`.

    Cut into 2, 4, 8, ... parts, at most MOST_PARTS: each part alone, and all without it. If those
    parts are longer than one: all but the last few. O(MOST_PARTS * n) in all.
    Source: Zeller, Hildebrandt, Simplifying and Isolating Failure-Inducing Input (2002).

    >>> list(parts(3))
    [[0], [1, 2], [0], [1, 2], [1], [0, 2], [2], [0, 1]]
    """
    pieces = 2
    while n > 1:
        pieces = min(pieces, n, MOST_PARTS)
        ends = [n * i // pieces for i in range(pieces + 1)]
        for start, end in pairwise(ends):
            if end - start >= least:
                yield list(range(start, end))
            if pieces > 2 and n - (end - start) >= least:
                yield [*range(start), *range(end, n)]
        if pieces in (n, MOST_PARTS):
            break
        pieces *= 2
    dropped = n // MOST_PARTS
    while dropped:
        yield list(range(n - dropped))
        dropped //= 2
