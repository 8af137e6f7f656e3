"""The statement as Polygon wants it: by section, and as one document for its olymp.sty."""

from __future__ import annotations

from export.files import Files
from export.package import Package
from export.statement.figures import figure_pdf
from export.statement.latex import escape, latex, notes
from export.statement.pdf import statement_pdf
from export.targets.polygon.descriptor import ANSWER, LATEX

SECTIONS = "statement-sections/english"
PDF = "statements/.pdf/english/problem.pdf"
DOCUMENT = LATEX.rpartition("/")[0]
EXAMPLE = "example.{:02d}"
# The headings of olymp.sty, in its order, before the examples.
HEADINGS = {"legend": "", "input": r"\InputFile", "output": r"\OutputFile", "scoring": r"\Scoring"}
NOTES = r"\Note"


def statement(package: Package) -> Files:
    """Return sections, document, examples and figures, in the places where Polygon has them."""
    files = Files()
    parts = sections(package)
    for name, text in parts.items():
        files.add(f"{SECTIONS}/{name}.tex", text)
    files.add(LATEX, document(package, parts))
    figures = {f"{note.figure.stem}.pdf": note.figure for note in package.statement.notes}
    contents = {name: figure_pdf(path) for name, path in figures.items()}
    for folder in (SECTIONS, DOCUMENT):
        for number, case in enumerate(package.samples, 1):
            files.add(f"{folder}/{EXAMPLE.format(number)}", case.input)
            files.add(f"{folder}/{EXAMPLE.format(number)}{ANSWER}", case.answer)
        for name, content in contents.items():
            files.add(f"{folder}/{name}", content)
    files.add(PDF, pdf(package))
    return files


def sections(package: Package) -> dict[str, str]:
    """Return the sections in LaTeX, by the name that Polygon gives them."""
    source = package.statement
    constraints = latex(source.section("Constraints").body)
    return {
        "name": escape(source.title),
        "legend": latex(source.section("").body),
        "input": f"{latex(source.section('Input').body)}\n{constraints}",
        "output": latex(source.section("Output").body),
        "scoring": latex(source.section("Groups").body),
        "notes": notes(source, "{}.pdf", heading=r"\textbf"),
    }


def document(package: Package, parts: dict[str, str]) -> str:
    """Return problem.tex, which is compiled with Polygon's olymp.sty."""
    limits = package.problem.limits
    head = (
        parts["name"],
        "standard input",
        "standard output",
        f"{limits.time_limit_s:g} seconds",
        f"{limits.memory_mib} megabytes",
    )
    examples = "\n".join(
        rf"\exmpfile{{{EXAMPLE.format(number)}}}{{{EXAMPLE.format(number)}{ANSWER}}}%"
        for number, _ in enumerate(package.samples, 1)
    )
    lines = [
        r"\begin{problem}" + "".join(f"{{{each}}}" for each in head),
        *(f"{heading}\n{parts[name]}" for name, heading in HEADINGS.items()),
        r"\Examples",
        "",
        r"\begin{example}",
        examples,
        r"\end{example}",
        "",
        NOTES,
        parts["notes"],
        r"\end{problem}",
    ]
    return "\n".join(lines) + "\n"


def pdf(package: Package) -> bytes:
    """Return the finished statement, for readers of packages that show it as it is."""
    source = package.statement
    return statement_pdf(source, source.sections, package.samples)
