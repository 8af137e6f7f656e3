"""Nearly identical programs: the fast search finds what all pairs say."""

from __future__ import annotations

import random

from judge.batch.rows import Row, notes
from judge.batch.similar import LEAST, nearly_identical, shingles
from judge.kit.paths import ROOT
from judge.languages.submission import Submission
from judge.languages.table import by_name

PYTHON, CPP = by_name("python"), by_name("cpp")
LONG = "\n".join(f"x{n} = solve({n}, 'a # b') + {n * n}" for n in range(20))


def test_comments_and_white_space_do_not_count_and_names_do() -> None:
    plain = shingles(LONG.encode(), PYTHON)
    noisy = LONG.replace(" + ", "  +\t").replace("\n", "  # why 'this'\n\n")
    assert shingles(noisy.encode(), PYTHON) == plain
    assert shingles(LONG.replace("solve", "f").encode(), PYTHON) != plain
    assert shingles(LONG.replace("# b", "# c").encode(), PYTHON) != plain, "it is in a string"
    code = "int main() { int a = 1 / 2; return f(a); }\n" * 5
    noisy = "/* it's\n a */" + code.replace("; ", "; // it's\n")
    assert shingles(noisy.encode(), CPP) == shingles(code.encode(), CPP)


def test_short_programs_are_like_nothing() -> None:
    assert shingles(b"print('YES')\n", PYTHON) == frozenset()
    assert not nearly_identical([frozenset(), frozenset()])


def test_the_search_finds_exactly_what_all_pairs_say() -> None:
    chance = random.Random(5)
    programs = []
    for _ in range(60):
        base = set(range(chance.randrange(3) * 1000, chance.randrange(3) * 1000 + 40))
        base |= {chance.randrange(10_000) for _ in range(chance.randrange(12))}
        programs.append(frozenset(base))
    found = nearly_identical(programs)
    pairs = 0
    for a, one in enumerate(programs):
        expected = set()
        for b, other in enumerate(programs):
            if a != b and one and len(one & other) >= LEAST * len(one | other):
                expected.add(b)
        assert {other for _, other in found.get(a, [])} == expected
        pairs += len(expected)
    assert pairs > 20


def test_the_kits_own_programs_are_not_all_alike() -> None:
    paths = sorted((ROOT / "submissions" / "accepted").glob("*.py"))
    found = nearly_identical([shingles(path.read_bytes(), PYTHON) for path in paths])
    assert len(found) < len(paths) / 2


def test_notes_name_the_others() -> None:
    sources = [LONG, LONG, LONG + "\nprint(x1)", "pass", LONG.replace("x", "y")]
    rows = [
        Row(f"student {n}", f"{n}.py", False, Submission("", PYTHON, text.encode()))
        for n, text in enumerate(sources)
    ]
    rows.append(Row("nobody", "6.py", False, None, "expected one source file, found none"))
    found = notes(rows)
    assert found[0].startswith("identical to student 1, 1.py; nearly identical to student 2")
    assert found[2].startswith("nearly identical to student 0, 0.py (98 %)")
    assert found[3:] == ["", "", ""]
