"""Spoiled input files, for comparing a judge's validator with the kit's own."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache
from io import BytesIO

from gen.geometry import Polygon
from gen.rng import Rng
from gen.scenario import Scenario, parse, render
from gen.validator import InputError, load_rules, validate

NUMBERS = (
    b"0 -0 00 01 -01 +1 1.0 1e3 0x1 ,1 - 2 3 -1 100000 100001 500000 500001 1000000 -100000000 "
    b"100000000 100000001 -100000001 200000000 -200000001 2147483647 2147483648 -2147483649 "
    b"4294967297 9223372036854775807 9223372036854775808 999999999999999999 "
    b"1000000000000000000 18446744073709551617 99999999999999999999"
).split()
BYTES = b" \t\n\r\v\f\x00\x1a0179-+.aZ\x7f\x80\xff"

rules_of = cache(load_rules)


def valid(content: bytes, group: str | None) -> bool:
    """Tell whether the kit's validator passes a file."""
    try:
        validate(BytesIO(content), rules_of(group))
    except InputError:
        return False
    return True


def spoiled_inputs(seed: int, sources: Sequence[bytes], count: int) -> Iterator[bytes]:
    """Yield files with one or two changes each; some of them are still valid.

    sources: valid files, small ones.
    """
    rng = Rng(seed)
    for _ in range(count):
        content = rng.choice(sources)
        for _ in range(rng.between(1, 2)):
            change = rng.choice((_bytes, _lines, _numbers, _whole))
            content = change(rng, content)
        yield _shapes(rng, rng.choice(sources)) if rng.chance(0.3) else content


def _bytes(rng: Rng, content: bytes) -> bytes:
    """Replace, insert or delete one byte, anywhere or at the end."""
    at = len(content) if rng.chance(0.1) else rng.below(len(content) + 1)
    byte = bytes([rng.choice(BYTES) if rng.chance(0.8) else rng.below(256)])
    match rng.below(3):
        case 0:
            return content[:at] + byte + content[at + 1 :]
        case 1:
            return content[:at] + byte + content[at:]
    return content[:at] + content[at + 1 :]


def _lines(rng: Rng, content: bytes) -> bytes:
    """Drop, double or swap lines, or add a blank to one."""
    lines = content.splitlines(keepends=True) or [b""]
    at = rng.below(len(lines))
    match rng.below(6):
        case 0:
            del lines[at]
        case 1:
            lines.insert(at, lines[at])
        case 2:
            other = rng.below(len(lines))
            lines[at], lines[other] = lines[other], lines[at]
        case 3:
            lines[at] = lines[at].rstrip(b"\n") + rng.choice((b" \n", b"\r\n", b"\t\n", b"\n\n"))
        case 4:
            lines[at] = rng.choice((b" ", b"\n", b"0", b"+")) + lines[at]
        case 5:
            lines[at] = lines[at].replace(b" ", rng.choice((b"  ", b"\t", b"\n", b" \n")))
    return b"".join(lines)


def _numbers(rng: Rng, content: bytes) -> bytes:
    """Replace one number: by one from a list, or by a near one."""
    lines = [line.split(b" ") for line in content.split(b"\n")]
    at = rng.below(len(lines))
    line = lines[at]
    token = rng.below(len(line))
    if rng.chance(0.5):
        line[token] = rng.choice(NUMBERS)
    elif line[token].lstrip(b"-").isdigit() and len(line[token]) < 20:
        line[token] = b"%d" % (int(line[token]) + rng.between(-2, 2))
    return b"\n".join(map(b" ".join, lines))


def _whole(rng: Rng, content: bytes) -> bytes:
    """Change the whole file: line ends, its end, a piece lost."""
    match rng.below(5):
        case 0:
            return content.replace(b"\n", b"\r\n")
        case 1:
            return content + rng.choice((b"\n", b" ", b"0", b"\x00", b"\xff", b"\x1a"))
        case 2:
            return content[: rng.below(len(content) + 1)]
        case 3:
            return content.removesuffix(b"\n")
    return rng.choice((b"\xef\xbb\xbf", b"\n", b" ", b"\xff")) + content


def _shapes(rng: Rng, content: bytes) -> bytes:
    """Change one polygon, or the move, of a valid file."""
    scenarios = parse(content)
    at = rng.below(len(scenarios))
    scene = scenarios[at]
    if rng.chance(0.2):
        reach = rng.choice((1, 10**8, 10**8 + 1, 2 * 10**8, 2 * 10**8 + 1))
        scene = replace(scene, move=(rng.between(-reach, reach), rng.choice((0, reach, -reach))))
    elif scene.obstacles and rng.chance(0.5):
        which = rng.below(len(scene.obstacles))
        obstacles = list(scene.obstacles)
        obstacles[which] = _polygon(rng, obstacles[which])
        scene = Scenario(scene.robot, scene.move, obstacles)
    else:
        scene = Scenario(_polygon(rng, scene.robot), scene.move, scene.obstacles)
    scenarios[at] = scene
    return render(scenarios)


def _polygon(rng: Rng, polygon: Polygon) -> Polygon:
    """Return a polygon in another form; a few of the forms are valid ones."""
    n = len(polygon)
    at = rng.below(n)
    (ax, ay), (bx, by) = polygon[at], polygon[(at + 1) % n]
    match rng.below(7):
        case 0:
            return polygon[::-1]
        case 1:  # a straight corner
            doubled = [(2 * x, 2 * y) for x, y in polygon]
            return [*doubled[: at + 1], (ax + bx, ay + by), *doubled[at + 1 :]]
        case 2:
            return [*polygon[: at + 1], polygon[at], *polygon[at + 1 :]]
        case 3:
            return polygon[at:] + polygon[:at]
        case 4:  # twice around, as a star if there are enough vertices
            return polygon + polygon if n < 5 else polygon[::2] + polygon[1::2]
        case 5:
            return polygon[:at] + polygon[at + 1 :]
    return [*polygon[:at], (ax + rng.between(-1, 1), ay + rng.between(-1, 1)), *polygon[at + 1 :]]
