"""The plan, and the commands that read it."""

import pytest

from gen.families import FAMILIES
from gen.plan import PLAN, PlanError, load_plan


def test_names_are_unique_and_no_two_cases_are_made_alike():
    plan = load_plan()
    assert len({recipe.case_name for recipe in plan}) == len(plan) >= 50
    made = [recipe for recipe in plan if recipe.family]
    recipes = {(r.family, repr(r.resolved()), r.repeat) for r in made}
    assert len(recipes) == len(made)


def test_all_shared_parameters_are_used():
    text = PLAN.read_text()
    shared = text[text.index("[shared]") : text.index("[cases.")]
    for line in shared.splitlines()[1:]:
        name, equals, _ = line.partition(" = ")
        assert not equals or f'"{name}"' in text, name


CASE = "[shared]\nstill = { move = 'zero' }\n[cases.small]\n"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"[shared]\n[shared]", "not valid TOML: "),
        (b"\xff", "not UTF-8 text (byte 0)"),
        (b"[shared]", "Object missing required field `cases`"),
        (b"[shared]\n[case]", "unknown key 'case'; did you mean 'cases'?"),
        (
            f"{CASE}x = {{ famly = 'cuts' }}",
            "cases.small.x: unknown key 'famly'; did you mean 'family'?",
        ),
        (
            f"{CASE}x = {{ family = 'cusp' }}",
            "cases.small.x: no family 'cusp'; did you mean 'cuts'?",
        ),
        (
            f"{CASE}x = {{ family = 'cuts', use = ['stil'] }}",
            "cases.small.x: use: no shared parameters 'stil'; did you mean 'still'?",
        ),
        (
            f"{CASE}x = {{ family = 'cuts', parameters = {{ reech = 1 }} }}",
            "cases.small.x: family cuts: no parameter 'reech'; did you mean 'reach'?",
        ),
        (
            f"{CASE}x = {{ family = 'cuts', parameters = {{ reach = 0 }} }}",
            "parameter reach: expected an integer of 1..",
        ),
        (
            f"{CASE}x = {{ family = 'cuts', parameters = {{ reach = 1.5 }} }}",
            "cases.small.x: parameters[...]: Expected `int | str`, got `float`",
        ),
        (
            f"{CASE}x = {{ family = 'cuts', repeat = 0 }}",
            "cases.small.x: repeat: Expected `int` >= 1",
        ),
        (f"{CASE}x = 3", "cases.small.x: Expected `object`, got `int`"),
        (f"{CASE}x = {{ use = ['still'] }}", "cases.small.x: expected a family"),
        (f"{CASE}X = {{}}", "cases.small.X: name: expected 1 to 61 small letters"),
        (f"{CASE}[cases.smal]\nx = {{}}", "cases.smal.x: no group 'smal'; did you mean 'small'?"),
    ],
)
def test_a_broken_plan_is_one_clear_line(tmp_path, content, message):
    path = tmp_path / "plan.toml"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(PlanError) as caught:
        load_plan(path)
    assert str(caught.value).startswith(f"{path}: ")
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


def test_make_prints_a_valid_file(gen, capfdbinary):
    assert gen("make", "contacts", "--seed", 7, "--set", "vertices=300", "reach=5") == 0
    once = capfdbinary.readouterr().out
    assert gen("make", "contacts", "--seed", 7, "--set", "vertices=300", "--set", "reach=5") == 0
    assert capfdbinary.readouterr().out == once
    assert once.count(b"\n") > 100


def test_list_shows_every_family_and_every_case(gen, capsys):
    assert gen("list") == 0
    shown = capsys.readouterr().out
    assert all(recipe.case_name in shown for recipe in load_plan())
    assert all(name in shown for name in FAMILIES)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["make", "contcats"], "no family 'contcats'; did you mean 'contacts'?"),
        (["make", "contacts", "--set", "reach"], "--set: expected NAME=VALUE, found 'reach'"),
        (["make", "contacts", "--set", "reech=2"], "did you mean 'reach'?"),
        (["make", "xyzzy"], f"no family 'xyzzy'; expected one of {next(iter(FAMILIES))}, "),
        (["make", "contacts", "--set", "reach=1_0"], "expected an integer of 1..200000000, found"),
        (
            ["make", "contacts", "--set", "reach=1", "reach=2"],
            "expected reach once, found it again",
        ),
        (["case", "contacts", "--group", "small", "--seed", "1" * 63], "the seed is too long"),
        (["check", "--data", "nowhere"], "--data: expected a data directory, found nowhere"),
        (["build", "secret/none/*"], "no case matches 'secret/none/*'"),
        (["case", "contacts", "--group", "smal"], "no group 'smal'"),
        (["case", "contacts", "--group", "small", "--name", "../x"], "--name: expected"),
        (["case", "--group", "small"], "expected a FAMILY, or --file"),
        (["case", "contacts", "--file", "x.in", "--group", "small"], "expected --file alone"),
        (["check", "--group", "smal", "x"], "no group 'smal'"),
        (["check", "--group", "small"], "--group: expected FILE with it"),
        (["remove", "x"], "no added case 'x'"),
    ],
)
def test_usage_errors_are_one_line(gen, arguments, message, capsys):
    assert gen(*arguments) == 2
    errors = capsys.readouterr().err
    assert message in errors
    assert errors.count("\n") == 1


@pytest.mark.parametrize("jobs", ["0", "-1", "two"])
def test_a_senseless_number_of_jobs_is_a_usage_error(gen, jobs, capsys):
    assert gen("build", "--jobs", jobs) == 2
    message = f"argument --jobs: expected a whole number of at least 1, found '{jobs}'"
    assert capsys.readouterr().err.endswith(f"{message}\n")
