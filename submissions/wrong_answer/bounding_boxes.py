#!/usr/bin/env python3
"""Compares bounding boxes only: the sweep's with the obstacle's."""

import sys


def main():
    numbers = list(map(int, sys.stdin.buffer.read().split()))
    at = 1
    answers = []
    for _ in range(numbers[0]):
        m, k, dx, dy = numbers[at : at + 4]
        (left, right, low, high), at = read_box(numbers, at + 4, m)
        left, right = min(left, left + dx), max(right, right + dx)
        low, high = min(low, low + dy), max(high, high + dy)
        answer = "YES"
        for _ in range(k):
            (west, east, south, north), at = read_box(numbers, at + 1, numbers[at])
            if left <= east and west <= right and low <= north and south <= high:
                answer = "NO"
        answers.append(answer)
    print("\n".join(answers))


def read_box(numbers, at, n):
    """Return the box of the n points that begin at index `at`, and the index behind them."""
    end = at + 2 * n
    xs, ys = numbers[at:end:2], numbers[at + 1 : end : 2]
    return (min(xs), max(xs), min(ys), max(ys)), end


if __name__ == "__main__":
    main()
