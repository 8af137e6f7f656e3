"""Randomness that is the same on every Python and platform, and the seeds it begins with.

Only `random.Random(seed).random()` and `getrandbits` are promised to stay
stable, so everything here is built on those two.
"""

from __future__ import annotations

import hashlib
import json
import random
from collections.abc import Mapping, MutableSequence, Sequence
from typing import TypeVar

T = TypeVar("T")

SALT = "collision-course-1"


def derive(family: str, parameters: Mapping[str, int | str], repeat: int) -> int:
    """Return the 64-bit seed of a test case: the head of a SHA-256 sum over its description.

    The seed depends on nothing but the description, so adding a case changes no other.
    parameters: all of the family's, defaults filled in; their order does not matter.
    """
    text = json.dumps([SALT, family, sorted(parameters.items()), repeat], separators=(",", ":"))
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:8], "big")


class Rng:
    """A seeded source of integers, choices and orders."""

    def __init__(self, seed: int) -> None:
        source = random.Random(seed)
        self._bits = source.getrandbits
        self._random = source.random

    def below(self, n: int) -> int:
        """Return an integer of 0..n-1, each equally likely; n >= 1. Expected O(1)."""
        width = n.bit_length()
        value = self._bits(width)
        while value >= n:
            if n < 1:
                raise ValueError(f"below: expected n >= 1, found {n}")
            value = self._bits(width)
        return value

    def between(self, low: int, high: int) -> int:
        """Return an integer of low..high, both included."""
        return low + self.below(high - low + 1)

    def several(self, count: int, low: int, high: int) -> list[int]:
        """Return as many integers as `count` calls of `between`, the same ones, but faster."""
        n = high - low + 1
        if n < 1:
            raise ValueError(f"several: expected low <= high, found {low} and {high}")
        bits, width = self._bits, n.bit_length()
        found = []
        for _ in range(count):
            value = bits(width)
            while value >= n:
                value = bits(width)
            found.append(low + value)
        return found

    def chance(self, probability: float) -> bool:
        """Return True with the given probability."""
        return self._random() < probability

    def choice(self, items: Sequence[T]) -> T:
        """Return one of the items; there is at least one."""
        return items[self.below(len(items))]

    def shuffle(self, items: MutableSequence[T]) -> None:
        """Bring the items into random order, in place (Fisher-Yates)."""
        for last in range(len(items) - 1, 0, -1):
            other = self.below(last + 1)
            items[last], items[other] = items[other], items[last]

    def subset(self, items: Sequence[T], size: int) -> list[T]:
        """Return `size` of the items in their given order. O(len(items)).

        Source: Knuth, The Art of Computer Programming, vol. 2, 3.4.2, algorithm S.
        """
        if size > len(items):
            raise ValueError(f"subset: expected at most {len(items)} items, found {size}")
        taken: list[T] = []
        random_, take = self._random, taken.append
        for left, item in zip(range(len(items), 0, -1), items, strict=True):
            if random_() * left < size:
                take(item)
                size -= 1
        return taken
