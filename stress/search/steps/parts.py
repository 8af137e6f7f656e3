"""Which parts of a list to try alone, and which to try without."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

MOST_PARTS = 64


def parts(n: int, least: int = 0) -> Iterator[list[int]]:
    """Yield lists of indices of 0..n-1 that keep some of them, in order, at least `least`.

    One half, a quarter, ... alone; all but a half, all but a quarter, ...; finally all but
    one, if n is at most MOST_PARTS. O(MOST_PARTS * n) in all.
    Source: Zeller, Hildebrandt, Simplifying and Isolating Failure-Inducing Input (2002).
    """
    pieces = 2
    while n > 1:
        pieces = min(pieces, n)
        ends = [n * i // pieces for i in range(pieces + 1)]
        for start, end in pairwise(ends):
            if end - start >= least:
                yield list(range(start, end))
            if pieces > 2 and n - (end - start) >= least:
                yield [*range(start), *range(end, n)]
        if pieces == min(n, MOST_PARTS):
            return
        pieces *= 2
