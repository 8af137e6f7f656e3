"""Random outputs beside their answers, for comparing a judge's checker with `judge.compare`."""

from __future__ import annotations

from collections.abc import Iterator
from io import BytesIO

from gen.rng import Rng
from judge.compare import compare

SPACES = (b" ", b"\n", b"\t", b"\r\n", b"\n\n", b"\v", b"\f", b" \n ")
WORDS = (b"Y", b"YESNO", b"yep", b"0", b"1", b"-1", b"maybe", b"N O", b"\xff", b"\x00", b"YES\x00")
MOST_TOKENS = 9


def random_outputs(seed: int, count: int) -> Iterator[tuple[bytes, bytes]]:
    """Yield pairs of an output and an answer; the outputs are right, or nearly."""
    rng = Rng(seed)
    for _ in range(count):
        answer = [rng.choice((b"YES", b"NO")) for _ in range(rng.between(1, MOST_TOKENS))]
        output = list(answer)
        if rng.chance(0.6):
            _spoil(rng, output)
        joined = b"".join(_cased(rng, token) + _space(rng) for token in output)
        if rng.chance(0.3):
            joined = _space(rng) + joined.rstrip()
        yield joined, b"\n".join(answer) + b"\n"


def accepted(output: bytes, answer: bytes) -> bool:
    """Tell whether the kit's judge accepts an output."""
    return compare(BytesIO(output), BytesIO(answer)) is None


def _spoil(rng: Rng, tokens: list[bytes]) -> None:
    """Change one thing."""
    at = rng.below(len(tokens))
    match rng.below(5):
        case 0:
            del tokens[at]
        case 1:
            tokens.insert(at, rng.choice((b"YES", b"NO")))
        case 2:
            tokens[at] = rng.choice(WORDS)
        case 3:
            tokens.append(rng.choice(WORDS))
        case 4:
            tokens[at] = b"NO" if tokens[at] == b"YES" else b"YES"


def _cased(rng: Rng, token: bytes) -> bytes:
    return rng.choice((token, token, token.lower(), token.title(), token.swapcase()))


def _space(rng: Rng) -> bytes:
    return b"\n" if rng.chance(0.7) else rng.choice(SPACES)
