"""The output validator: compares the tokens of an output with those of the answer file.

White space only separates tokens, and the case of ASCII letters does not matter.
The answer has one token per scenario, so the number of a token is the number of
its scenario.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import BinaryIO

from judge.kit.text import printable

BLOCK_BYTES = 1 << 16


@dataclass(frozen=True, slots=True)
class Mismatch:
    """The first difference between an output and the answer.

    scenario: 1-based number of the token. line, column: 1-based, its place in the
    output; for a missing token, the end of the output. expected: None if the output
    has too many tokens. found: None if it has too few. At most one of the two is None.
    """

    scenario: int
    line: int
    column: int
    expected: str | None
    found: str | None

    @property
    def out_of_step(self) -> bool:
        """Whether the output has too few or too many tokens."""
        return self.expected is None or self.found is None

    def __str__(self) -> str:
        where = f"line {self.line}, column {self.column}"
        if self.expected is None:
            return (
                f"too much output: expected the end after {self.scenario - 1} answers, "
                f"found {self.found} ({where})"
            )
        found = "the end of the output" if self.found is None else self.found
        return f"scenario {self.scenario}: expected {self.expected}, found {found} ({where})"


def compare(output: BinaryIO, answer: BinaryIO) -> Mismatch | None:
    """Return the first difference, or None if the tokens are the same.

    output, answer: seekable and at their beginning. Linear time; memory is one
    block and one token of each, however large they are.
    """
    found_blocks, expected_blocks = _token_blocks(output), _token_blocks(answer)
    found: list[bytes] = []
    expected: list[bytes] = []
    compared = 0
    while True:
        found = found or next(found_blocks, [])
        expected = expected or next(expected_blocks, [])
        common = min(len(found), len(expected))
        if common == 0:
            if not found and not expected:
                return None
            return _locate(
                output, compared, expected[0] if expected else None, found[0] if found else None
            )
        if _folded(found[:common]) != _folded(expected[:common]):
            i = next(i for i in range(common) if found[i].lower() != expected[i].lower())
            return _locate(output, compared + i, expected[i], found[i])
        compared += common
        found, expected = found[common:], expected[common:]


def _folded(tokens: list[bytes]) -> bytes:
    # Tokens hold no space, so joining them loses nothing; one lower() is faster than many.
    return b" ".join(tokens).lower()


def _token_blocks(stream: BinaryIO) -> Iterator[list[bytes]]:
    """Yield the tokens of `stream` in order, in non-empty lists."""
    pieces: list[bytes] = []  # of a token that may continue in the next block
    while block := stream.read(BLOCK_BYTES):
        tokens = block.split()
        if pieces and not block[:1].isspace():
            pieces.append(tokens.pop(0))
            if not tokens and not block[-1:].isspace():
                continue
        if pieces:
            tokens.insert(0, b"".join(pieces))
        pieces = [] if block[-1:].isspace() else [tokens.pop()]
        if tokens:
            yield tokens
    if pieces:
        yield [b"".join(pieces)]


def _locate(output: BinaryIO, index: int, expected: bytes | None, found: bytes | None) -> Mismatch:
    """Return the mismatch of token `index` (0-based), with its place in the output."""
    output.seek(0)
    line, column = _position(output, index)
    return Mismatch(
        scenario=index + 1,
        line=line,
        column=column,
        expected=None if expected is None else printable(expected),
        found=None if found is None else printable(found),
    )


def _position(output: BinaryIO, index: int) -> tuple[int, int]:
    """Return line and column of token `index`, or of the end if there are fewer tokens."""
    line, column, inside = 1, 1, False
    while block := output.read(BLOCK_BYTES):
        for byte in block:
            space = byte in b" \t\n\r\x0b\x0c"
            if not space and not inside:
                if index == 0:
                    return line, column
                index -= 1
            inside = not space
            line, column = (line + 1, 1) if byte == 10 else (line, column + 1)
    return line, column
