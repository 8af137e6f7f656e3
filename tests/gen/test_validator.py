"""The input validator: one test file per fault, and mutations against a second parser."""

import io
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gen.validator import InputError, Rules, Summary, UsageError, load_rules, validate
from judge.kit.paths import ROOT

INVALID = ROOT / "data" / "invalid_input"
SAMPLE = (ROOT / "data" / "sample" / "01-first.in").read_bytes()

# Each file of data/invalid_input: the group it is held to (if any), the line, the reason.
FAULTS = tomllib.loads((INVALID / "faults.toml").read_text(encoding="utf-8"))


def fault(content, group=None):
    with pytest.raises(InputError) as caught:
        validate(io.BytesIO(content), load_rules(group))
    return caught.value.line, caught.value.reason


def test_there_is_one_file_per_fault():
    assert {path.stem for path in INVALID.glob("*.in")} == set(FAULTS)
    assert len(FAULTS) >= 40


@pytest.mark.parametrize("name", FAULTS)
def test_each_fault_is_found_on_its_line(name):
    expected = FAULTS[name]
    found = fault((INVALID / f"{name}.in").read_bytes(), expected.get("group"))
    assert found == (expected["line"], expected["reason"])


@pytest.mark.parametrize("name", [name for name in FAULTS if "group" in FAULTS[name]])
def test_promises_bind_their_group_only(name):
    content = (INVALID / f"{name}.in").read_bytes()
    if name == "group_large_too_much_k_times_m":  # cut off after the line that breaks it
        assert "end of the file" in fault(content, "many")[1]
    else:
        validate(io.BytesIO(content), load_rules("large"))


def test_a_valid_file_is_summed_up():
    assert validate(io.BytesIO(SAMPLE), load_rules("sample")) == Summary(2, 22, 16)


class Endless(io.RawIOBase):
    """A stream that never ends, and counts what was asked of it."""

    def __init__(self, byte):
        self.byte, self.given = byte, 0

    def readline(self, size=-1):
        assert size > 0, "an unbounded read"
        self.given += size
        return self.byte * size


@pytest.mark.parametrize("byte", [b"1", b" ", b"\0", b"-"])
def test_an_endless_line_is_given_up_soon(byte):
    stream = Endless(byte)
    with pytest.raises(InputError):
        validate(stream, load_rules())
    assert stream.given < 1_000


def naive_verdict(content, rules):
    """Tell validity by other means: format what was read again, and compare bytes."""
    numbers = iter(content.decode("latin-1").split())
    lines = []

    def line(count):
        values = [int(next(numbers)) for _ in range(count)]
        lines.append(" ".join(map(str, values)))
        return values

    def polygon(n, moves):
        ring = [tuple(line(2)) for _ in range(n)]
        most = rules.max_coordinate
        bounded = all(
            abs(x + dx) <= most and abs(y + dy) <= most for x, y in ring for dx, dy in moves
        )
        # Strictly convex and once around: all others are left of every edge.
        edges = [(ring[i - 1], ring[i]) for i in range(n)]
        left = all(
            (b[0] - a[0]) * (p[1] - a[1]) > (b[1] - a[1]) * (p[0] - a[0])
            for i, (a, b) in enumerate(edges)
            for j, p in enumerate(ring)
            if j not in (i, (i - 1) % n)
        )
        return bounded and left and n >= rules.min_polygon_vertices

    try:
        (t,) = line(1)
        good, vertices = 1 <= t <= rules.max_scenarios, 0
        for _ in range(min(t, 100)):
            m, k = line(2)
            dx, dy = line(2)
            good &= k >= 0 and m >= 3 and polygon(m, [(0, 0), (dx, dy)])
            vertices += m
            for _ in range(min(k, 100)):
                (n,) = line(1)
                vertices += n
                good &= n >= 3 and polygon(n, [(0, 0)])
    except (StopIteration, RuntimeError, ValueError):
        return False
    good &= vertices <= rules.max_vertices
    return bool(good) and "".join(f"{text}\n" for text in lines).encode() == content


@st.composite
def mutants(draw):
    """A valid file with one byte, one token or one line changed, dropped or doubled."""
    kind = draw(st.sampled_from(["byte", "token", "line"]))
    if kind == "byte":
        parts, glue = [SAMPLE[i : i + 1] for i in range(len(SAMPLE))], b""
        new = draw(st.sampled_from([bytes([b]) for b in b"0123456789-+ \n\r\t.x\0"]))
    elif kind == "token":
        parts, glue = SAMPLE.replace(b"\n", b" \n ").split(b" "), b" "
        new = str(draw(st.integers(-20, 20) | st.sampled_from([10**8, 10**8 + 1, 10**40]))).encode()
    else:
        parts, glue = SAMPLE.split(b"\n"), b"\n"
        new = draw(st.sampled_from([b"", b"3", b"0 0", b"5 5", b"1 2 3"]))
    at = draw(st.integers(0, len(parts) - 1))
    change = draw(st.sampled_from([[new], [], [parts[at], parts[at]], [new, parts[at]]]))
    content = glue.join(parts[:at] + change + parts[at + 1 :])
    return content.replace(b" \n ", b"\n") if kind == "token" else content


@settings(max_examples=600)
@given(mutants())
def test_mutants_are_judged_as_by_a_second_parser(content):
    rules = load_rules()
    try:
        validate(io.BytesIO(content), rules)
        valid = True
    except InputError:
        valid = False
    assert valid == naive_verdict(content, rules)


def run(*arguments, stdin=b""):
    program = [sys.executable, str(ROOT / "gen" / "validator.py"), *map(str, arguments)]
    done = subprocess.run(program, input=stdin, capture_output=True, check=False)
    return done.returncode, done.stderr.decode()


def test_the_program_stands_alone():
    assert run(stdin=SAMPLE) == (0, "")
    assert run(stdin=b"0\n") == (1, "standard input:1: t: expected 1..100000, found 0\n")
    assert run("--group", "nix", stdin=SAMPLE)[0] == 2
    assert run(ROOT / "no-such-file")[0] == 2
    assert run(ROOT)[0] == 2


def test_several_files_are_read_up_to_the_first_fault(tmp_path: Path):
    good, bad = tmp_path / "good.in", tmp_path / "bad.in"
    good.write_bytes(SAMPLE)
    bad.write_bytes(b"0\n")
    assert run(good, good) == (0, "")
    assert run(good, bad, bad) == (1, f"{bad}:1: t: expected 1..100000, found 0\n")


def test_a_broken_declaration_is_one_clear_line(tmp_path: Path):
    for text in ("", "constraints = 3", "[constraints]\nmax = 1\n[[groups]]\nname = 'a'"):
        (tmp_path / "problem.toml").write_text(text)
        with pytest.raises(UsageError) as caught:
            load_rules(None, tmp_path / "problem.toml")
        assert "problem.toml" in str(caught.value)
        assert "\n" not in str(caught.value)
    assert isinstance(load_rules("static"), Rules)
