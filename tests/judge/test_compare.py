"""The comparison of tokens, against its definition."""

from __future__ import annotations

import io
from itertools import zip_longest
from unittest import mock

import pytest
from hypothesis import given
from hypothesis import strategies as st

from judge.compare import BLOCK_BYTES, Mismatch, compare
from judge.kit.text import printable

SPACES = st.text(" \t\n\r\x0b\x0c", min_size=1, max_size=4).map(str.encode)
TOKENS = st.lists(st.sampled_from([b"YES", b"no", b"No", b"yes", b"\x00", b"\xff", b"a" * 50]))

# A token may span any number of blocks.
BLOCKS = st.sampled_from([1, 2, 3, 7, BLOCK_BYTES])


def compared(output: bytes, answer: bytes, block_bytes: int = BLOCK_BYTES) -> Mismatch | None:
    with mock.patch("judge.compare.BLOCK_BYTES", block_bytes):
        return compare(io.BytesIO(output), io.BytesIO(answer))


def first_difference(output: bytes, answer: bytes) -> int | None:
    pairs = zip_longest(output.split(), answer.split())
    for number, (found, expected) in enumerate(pairs, 1):
        if found is None or expected is None or found.lower() != expected.lower():
            return number
    return None


@st.composite
def laid_out(draw: st.DrawFn, tokens: list[bytes]) -> bytes:
    """Put any white space around the tokens."""
    text = draw(SPACES | st.just(b""))
    for token in tokens:
        text += token + draw(SPACES)
    return text.rstrip() if draw(st.booleans()) else text


@given(TOKENS.flatmap(lambda t: st.tuples(laid_out(t), laid_out(t))), BLOCKS)
def test_white_space_does_not_matter(texts: tuple[bytes, bytes], block_bytes: int) -> None:
    assert compared(*texts, block_bytes) is None


@given(TOKENS.flatmap(laid_out))
def test_ascii_letter_case_does_not_matter(text: bytes) -> None:
    assert compared(text.upper(), text.lower()) is None


@given(TOKENS.flatmap(laid_out), TOKENS.flatmap(laid_out), BLOCKS)
def test_the_first_difference_is_found_and_placed(
    output: bytes, answer: bytes, block_bytes: int
) -> None:
    mismatch = compared(output, answer, block_bytes)
    assert (mismatch.scenario if mismatch else None) == first_difference(output, answer)
    if mismatch and mismatch.found is not None:
        line = output.split(b"\n")[mismatch.line - 1]
        token = output.split()[mismatch.scenario - 1]
        assert line[mismatch.column - 1 :].startswith(token)
    if mismatch:
        nth = slice(mismatch.scenario - 1, mismatch.scenario)
        assert [mismatch.expected] == ([*map(printable, answer.split()[nth])] or [None])
        assert [mismatch.found] == ([*map(printable, output.split()[nth])] or [None])


@given(st.integers(-3, 3), st.integers(0, 3))
def test_tokens_across_block_ends(offset: int, spaces: int) -> None:
    head = b"x" * (BLOCK_BYTES - spaces + offset) + b" " * spaces
    assert compared(head + b"YES NO", head + b" yes\nno") == compared(head + b"YES", head + b" yes")
    assert (compared(head + b"YES", head + b"YES") is None) is True
    joined = compared(b"a" * (BLOCK_BYTES + offset) + b" b", b"a" * (BLOCK_BYTES + offset) + b"b")
    assert joined is not None
    assert joined.scenario == 1


@pytest.mark.parametrize(
    ("output", "answer", "message"),
    [
        (b"YES\nYES\n", b"YES\nNO\n", "scenario 2: expected NO, found YES (line 2, column 1)"),
        (
            b"YES\n",
            b"YES\nNO\n",
            "scenario 2: expected NO, found the end of the output (line 2, column 1)",
        ),
        (
            b"YES\n  NO",
            b"YES\n",
            "too much output: expected the end after 1 answers, found NO (line 2, column 3)",
        ),
        (b"", b"NO", "scenario 1: expected NO, found the end of the output (line 1, column 1)"),
        (b"\x1b[2J", b"NO", r"scenario 1: expected NO, found \x1b[2J (line 1, column 1)"),
        (b"A" * 99, b"NO", f"scenario 1: expected NO, found {'A' * 40}… (line 1, column 1)"),
        (b"Y\0S", b"YES", r"scenario 1: expected YES, found Y\x00S (line 1, column 1)"),
    ],
)
def test_messages(output: bytes, answer: bytes, message: str) -> None:
    assert str(compared(output, answer)) == message


def test_a_flood_costs_little_memory() -> None:
    """Eight MiB of one-byte tokens would take hundreds of MiB as a list."""
    import tracemalloc

    flood = io.BytesIO(b"1 " * (4 << 20))
    tracemalloc.start()
    assert compare(flood, io.BytesIO(b"1 " * (4 << 20))) is None
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 64 << 20
