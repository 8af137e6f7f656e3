"""The list of equivalent mutants: it is true to the programs, and bad lists are refused."""

import pytest

from judge.kit.paths import ROOT
from judge.problem.declaration import load
from strength.mutants import equivalents
from strength.mutants.campaign import programs
from strength.mutants.equivalents import Equivalent, EquivalentsError, equivalent_of, unused
from strength.mutants.mutate import mutants

PROGRAM = b"def f(x):\n    return x + 1\n"


def entry(**changes):
    fields = {"function": "f", "line": "return x + 1", "mutated": ["return x - 1"], "proof": "so"}
    return Equivalent(program="p.py", **fields | changes)


def test_every_entry_names_a_mutant_of_today():
    every = [m for name in programs(load()) for m in mutants(name, (ROOT / name).read_bytes())]
    assert unused(equivalents.load(), every) == []


def test_an_entry_names_its_mutant_only():
    found = mutants("p.py", PROGRAM)
    assert [m.mutated for m in found if equivalent_of(m, [entry()])] == ["return x - 1"]
    assert not any(equivalent_of(m, [entry(function="g")]) for m in found)
    assert not any(equivalent_of(m, [entry(nth=2)]) for m in found)
    assert all(equivalent_of(m, [entry(mutated=["*"])]) for m in found)


def test_entries_without_a_mutant_are_named():
    found = mutants("p.py", PROGRAM)
    assert unused([entry(), entry(mutated=["*"])], found) == []
    assert unused([entry(mutated=["return x - 1", "return y"])], found) == [
        "p.py f: return x + 1  ->  return y"
    ]
    assert len(unused([entry(line="return x", mutated=["*"])], found)) == 1


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("[[equivalent]]\nprogram = 'p.py'\n", "line"),
        ("[[equivalent]]\nprof = 'p.py'\n", "prof"),
        ("[[equivalent", "equivalent.toml"),
    ],
)
def test_a_bad_list_is_refused(tmp_path, text, message):
    path = tmp_path / "equivalent.toml"
    path.write_text(text)
    with pytest.raises(EquivalentsError, match=message):
        equivalents.load(path)
    with pytest.raises(EquivalentsError, match="cannot be read"):
        equivalents.load(tmp_path / "none.toml")
