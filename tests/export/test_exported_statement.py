"""The statement in LaTeX and as PDF holds all of problem.md, or says what it cannot hold."""

from __future__ import annotations

from pathlib import Path

import pytest

from export.package import Package
from export.statement import latex
from export.statement.figures import figure_pdf
from export.statement.pdf import statement_pdf
from export.statement.read import Statement, StatementError, parser, plain, read_statement

PROBLEM = Path(__file__).parents[2] / "problem.md"


@pytest.fixture(scope="module")
def statement() -> Statement:
    return read_statement(PROBLEM)


def test_the_parts(statement: Statement) -> None:
    titles = ["", "Input", "Output", "Constraints", "Groups"]
    assert [section.title for section in statement.sections] == titles
    assert statement.title == "Collision Course"
    assert len(statement.notes) == 4
    assert all(note.figure.is_file() and note.title and note.body for note in statement.notes)
    assert [section.title for section in statement.without("Groups")] == titles[:-1]


def test_every_word_is_in_the_latex(statement: Statement) -> None:
    text = latex.sections(statement.sections) + latex.notes(statement, "{}.pdf")
    bare = "".join(sign for sign in text if sign.isalnum())
    nodes = [node for part in statement.sections for node in part.body]
    nodes += [node for note in statement.notes for node in note.body]
    texts = [plain(each) for node in nodes for each in node.walk() if each.type == "inline"]
    words = [word for text in texts for word in text.split() if word.isalnum()]
    assert len(words) > 300
    assert all(word in bare for word in words)
    for number in ("100,000,000", "500,000", "1,000,000"):
        assert number in text
    assert text.count(r"\includegraphics") == 4
    assert "```" not in text
    assert text.count("{") - text.count(r"\{") == text.count("}") - text.count(r"\}")


@pytest.mark.parametrize(
    ("text", "what"),
    [("> quoted", "blockquote"), ("a\n\n---\n", "hr"), ("![x](y)", "image"), ("snow ☃", "☃")],
)
def test_what_has_no_latex_is_named_with_its_line(tmp_path: Path, text: str, what: str) -> None:
    path = tmp_path / "problem.md"
    path.write_text(f"# Title\n\n{text}\n", encoding="utf-8")
    with pytest.raises(StatementError, match=rf"problem\.md:[35]: .*{what}"):
        latex.sections(read_statement(path).sections)


def test_special_signs_of_latex() -> None:
    assert latex.escape(r"50% of a_b & {c} #1 ~ ^ \ $") == (
        r"50\% of a\_b \& \{c\} \#1 \textasciitilde{} \textasciicircum{} "
        r"\textbackslash{} \$"
    )


def test_the_parser_reads_formulas_and_tables() -> None:
    types = {token.type for token in parser().parse("| a |\n| - |\n| $x$ |\n")}
    assert "table_open" in types


def test_pdfs_are_pdfs_with_equal_bytes(package: Package) -> None:
    statement = package.statement
    whole = statement_pdf(statement, statement.sections, package.samples)
    assert whole.startswith(b"%PDF")
    assert len(whole) > 10_000
    assert whole == statement_pdf(statement, statement.sections, package.samples)
    figure = figure_pdf(statement.notes[0].figure)
    assert figure.startswith(b"%PDF")
    assert figure == figure_pdf(statement.notes[0].figure)


def test_a_missing_figure_says_what_to_run(tmp_path: Path) -> None:
    with pytest.raises(StatementError, match="make figures"):
        figure_pdf(tmp_path / "none.svg")
