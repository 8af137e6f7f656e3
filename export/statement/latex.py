"""The statement as LaTeX, for judges that typeset it themselves.

Only what problem.md uses is converted; anything else is an error that names its line.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from export.statement.read import Node, Section, Statement, StatementError, line_of

# Every character that LaTeX reads as a command, and the signs of the statement.
ESCAPES = {
    "\\": r"\textbackslash{}",
    "&": r"\&",
    "%": r"\%",
    "$": r"\$",
    "#": r"\#",
    "_": r"\_",
    "{": r"\{",
    "}": r"\}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "|": r"$|$",
    "<": r"$<$",
    ">": r"$>$",
    "≤": r"$\le$",
    "≥": r"$\ge$",
    "·": r"$\cdot$",
    "×": r"$\times$",
    "⊕": r"$\oplus$",
    "–": "--",
    "—": "---",
    "’": "'",
    "“": "``",
    "”": "''",
    "\N{NO-BREAK SPACE}": "~",
}
GRAPHICS_WIDTH = r"0.7\textwidth"


def latex(nodes: Iterable[Node]) -> str:
    """Return block nodes as LaTeX, with a blank line between them. Raises StatementError."""
    return "\n\n".join(_block(node) for node in nodes) + "\n"


def sections(parts: Sequence[Section]) -> str:
    r"""Return sections as LaTeX, each under its \section*; the story has no heading."""
    text = []
    for part in parts:
        heading = f"\\section*{{{escape(part.title)}}}\n\n" if part.title else ""
        text.append(heading + latex(part.body))
    return "\n".join(text)


def notes(statement: Statement, figure: str, heading: str = r"\section*") -> str:
    """Return the remarks on the samples as LaTeX.

    figure: the file name of a sample's figure, with `{}` for its stem (`{}.pdf`).
    """
    text = [f"{heading}{{Remarks on the samples}}\n", latex(statement.before_notes)]
    for number, note in enumerate(statement.notes, 1):
        file = figure.format(note.figure.stem)
        text.append(
            f"\\textbf{{Sample {number}: {escape(note.title)}.}} {latex(note.body)}\n"
            f"\\begin{{center}}\n\\includegraphics[width={GRAPHICS_WIDTH}]{{{file}}}\n"
            "\\end{center}\n"
        )
    return "\n".join(text)


def escape(text: str) -> str:
    r"""Return plain text as LaTeX. Raises StatementError for an unknown sign.

    >>> escape("|x| ≤ 100,000 & more")
    '$|$x$|$ $\\\\le$ 100,000 \\\\& more'
    """
    for sign in text:
        if not sign.isascii() and sign not in ESCAPES:
            raise StatementError(f"expected a sign with a LaTeX form, found {sign!r}")
    return "".join(ESCAPES.get(sign, sign) for sign in text)


def _block(node: Node) -> str:
    match node.type:
        case "paragraph":
            return _inline(node.children)
        case "bullet_list":
            items = "\n".join(f"\\item {_item(each)}" for each in node.children)
            return f"\\begin{{itemize}}\n{items}\n\\end{{itemize}}"
        case "table":
            return _table(node)
    raise StatementError(f"problem.md:{line_of(node)}: {node.type}: no LaTeX form is known")


def _item(node: Node) -> str:
    return "\n\n".join(_block(each) for each in node.children)


def _table(node: Node) -> str:
    """Return a table; its last column takes the rest of the line and breaks."""
    rows = [
        [_inline(cell.children) for cell in row.children]
        for part in node.children
        for row in part.children
    ]
    columns = len(rows[0])
    width = f"{1 - 0.16 * columns:.2f}"
    lines = [" & ".join(row) + r" \\" for row in rows]
    head = " & ".join(rf"\textbf{{{cell}}}" for cell in rows[0]) + r" \\ \hline"
    spec = "l" * (columns - 1) + f"p{{{width}\\textwidth}}"
    if columns == 2:
        spec = r"p{0.5\textwidth}p{0.42\textwidth}"
    body = "\n".join([head, *lines[1:]])
    return f"\\begin{{tabular}}{{{spec}}}\n{body}\n\\end{{tabular}}"


def _inline(nodes: Iterable[Node]) -> str:
    return "".join(_phrase(node) for node in nodes)


def _phrase(node: Node) -> str:
    match node.type:
        case "inline":
            return _inline(node.children)
        case "text":
            try:
                return escape(node.content)
            except StatementError as error:
                raise StatementError(f"problem.md:{line_of(node)}: {error}") from None
        case "softbreak":
            return "\n"
        case "strong":
            return rf"\textbf{{{_inline(node.children)}}}"
        case "em":
            return rf"\emph{{{_inline(node.children)}}}"
        case "code_inline":
            return rf"\texttt{{{escape(node.content)}}}"
        case "math_inline":
            return f"${node.content}$"
    raise StatementError(f"problem.md:{line_of(node)}: {node.type}: no LaTeX form is known")
