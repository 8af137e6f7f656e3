"""The statement agrees with problem.toml, the samples and the figures."""

import re

import pytest

from judge.kit.paths import ROOT
from judge.problem import declaration
from pictures.cli import sample_figures

STATEMENT = (ROOT / "problem.md").read_text()
PROBLEM = declaration.load()
SAMPLES = sorted((ROOT / "data" / "sample").glob("*.in"))


def table(header):
    """Return the rows of the table that begins with the header line, as lists of cells."""
    _, _, rest = STATEMENT.partition(header + "\n")
    rows = [row.strip("|").split(" | ") for row in rest.partition("\n\n")[0].splitlines()[1:]]
    return [[cell.strip() for cell in row] for row in rows]


def test_the_groups_table():
    declared = [[g.name, str(g.points), g.promise] for g in PROBLEM.groups]
    assert table("| group | points | what its files promise |") == declared
    assert PROBLEM.max_score == 100


@pytest.mark.parametrize("group", PROBLEM.groups, ids=lambda group: group.name)
def test_a_promise_states_the_limits_that_the_validator_checks(group):
    assert ("0 0" in group.promise) == group.zero_displacement
    numbers = {int(n.replace(",", "")) for n in re.findall(r"\d[\d,]{3,}", group.promise)}
    checked = {group.max_vertices, group.max_pair_sum} - {None}
    assert numbers == checked or group.name == "sample"


def test_the_constraints_table():
    rows = dict(table("| what | limits |"))
    of, limits = PROBLEM.constraints, PROBLEM.limits
    assert list(rows.values()) == [
        f"1 ≤ t ≤ {of.max_scenarios:,}",
        f"m, n ≥ {of.min_polygon_vertices}",
        "k ≥ 0",
        f"at most {of.max_vertices:,}",
        rf"\|x\|, \|y\| ≤ {of.max_coordinate:,}",
        f"{limits.time_limit_s:g} seconds",
        f"{limits.memory_mib} MiB",
        f"{limits.output_mib} MiB",
        f"{limits.code_kib} KiB",
    ]


def test_there_are_samples_and_the_statement_shows_them_all():
    assert len(SAMPLES) >= 3
    assert len(re.findall(r"^### Sample", STATEMENT, re.MULTILINE)) == len(SAMPLES)


@pytest.mark.parametrize("sample", SAMPLES, ids=lambda sample: sample.stem)
def test_a_sample_is_shown_as_it_is(sample):
    shown = (
        f"Input:\n\n```\n{sample.read_text()}```\n\n"
        f"Output:\n\n```\n{sample.with_suffix('.ans').read_text()}```\n"
    )
    assert shown in STATEMENT
    assert f"](docs/figures/{sample.stem}.svg)" in STATEMENT


def test_the_figures_are_current():
    for path, svg in sample_figures().items():
        assert path.read_text() == svg, f"{path.name} is out of date: run 'make figures'"
