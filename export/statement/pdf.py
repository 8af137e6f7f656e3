"""The whole statement as one PDF, without LaTeX: for judges that show a finished document."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from html import escape
from io import BytesIO
from typing import Any

from export.statement.read import Node, Section, Statement, StatementError, line_of
from judge.problem.cases import Case

MARGIN_PT = 60
FORMULA = re.compile(r"([a-z])_([a-z])")  # d_x; the statement has no harder formula


def statement_pdf(statement: Statement, parts: Sequence[Section], samples: Sequence[Case]) -> bytes:
    """Return the PDF: the title, `parts`, and every sample with its figure and remarks.

    Equal statements give equal bytes. Raises StatementError.
    """
    from reportlab import rl_config
    from reportlab.lib.pagesizes import A4
    from reportlab.platypus import SimpleDocTemplate

    rl_config.invariant = 1
    writer = _Writer(A4[0] - 2 * MARGIN_PT)
    story = writer.document(statement, parts, samples)
    stream = BytesIO()
    SimpleDocTemplate(
        stream,
        pagesize=A4,
        title=statement.title,
        leftMargin=MARGIN_PT,
        rightMargin=MARGIN_PT,
        topMargin=MARGIN_PT,
        bottomMargin=MARGIN_PT,
    ).build(story)
    return stream.getvalue()


class _Writer:
    """Turns nodes into the flowables of reportlab. width: of the text, in points."""

    def __init__(self, width: float) -> None:
        from reportlab.lib.styles import ParagraphStyle, getSampleStyleSheet

        sheet = getSampleStyleSheet()
        self._width = width
        self._title = sheet["Title"]
        self._heading = sheet["Heading2"]
        self._small_heading = sheet["Heading3"]
        self._text = ParagraphStyle(
            "text",
            parent=sheet["BodyText"],
            fontName="Times-Roman",
            fontSize=11,
            leading=14,
            spaceAfter=6,
        )
        self._code = ParagraphStyle(
            "code", parent=sheet["Code"], fontSize=9, leading=10.5, leftIndent=0
        )

    def document(
        self, statement: Statement, parts: Sequence[Section], samples: Sequence[Case]
    ) -> list[Any]:
        from reportlab.platypus import KeepTogether, Paragraph

        story: list[Any] = [Paragraph(escape(statement.title), self._title)]
        for part in parts:
            if part.title:
                story.append(Paragraph(escape(part.title), self._heading))
            story += self._blocks(part.body)
        story.append(Paragraph("Samples", self._heading))
        story += self._blocks(statement.before_notes)
        for number, (note, case) in enumerate(zip(statement.notes, samples, strict=True), 1):
            heading = Paragraph(f"Sample {number}: {escape(note.title)}", self._small_heading)
            story.append(KeepTogether([heading, self._figure(note.figure)]))
            story += self._blocks(note.body)
            story.append(self._sample(case))
        return story

    def _blocks(self, nodes: Iterable[Node]) -> list[Any]:
        return [self._block(node) for node in nodes]

    def _block(self, node: Node) -> Any:
        from reportlab.platypus import ListFlowable, Paragraph

        match node.type:
            case "paragraph":
                return Paragraph(_inline(node.children), self._text)
            case "bullet_list":
                items = [self._blocks(item.children) for item in node.children]
                return ListFlowable(items, bulletType="bullet", start="•", leftIndent=14)
            case "table":
                return self._table(node)
        raise StatementError(f"problem.md:{line_of(node)}: {node.type}: no PDF form is known")

    def _table(self, node: Node) -> Any:
        from reportlab.lib import colors
        from reportlab.platypus import Paragraph, Table

        rows = [
            [Paragraph(_inline(cell.children), self._text) for cell in row.children]
            for part in node.children
            for row in part.children
        ]
        columns = len(rows[0])
        first = [0.5, 0.5] if columns == 2 else [0.15] * (columns - 1)
        shares = first if columns == 2 else [*first, 1 - sum(first)]
        table = Table(rows, colWidths=[share * self._width for share in shares])
        table.setStyle(
            [
                ("LINEBELOW", (0, 0), (-1, 0), 0.7, colors.black),
                ("VALIGN", (0, 0), (-1, -1), "TOP"),
                ("BOTTOMPADDING", (0, 0), (-1, -1), 0),
                ("TOPPADDING", (0, 0), (-1, -1), 1),
            ]
        )
        return table

    def _figure(self, path: Any) -> Any:
        from svglib.svglib import svg2rlg

        drawing = svg2rlg(str(path))
        if drawing is None:
            raise StatementError(f"{path}: not a drawing that can be converted")
        scale = min(1.0, self._width / drawing.width)
        drawing.scale(scale, scale)
        drawing.width *= scale
        drawing.height *= scale
        return drawing

    def _sample(self, case: Case) -> Any:
        from reportlab.lib import colors
        from reportlab.platypus import Paragraph, Preformatted, Table

        texts = [path.read_text(encoding="ascii").rstrip() for path in (case.input, case.answer)]
        rows: list[list[Any]] = [
            [Paragraph("<b>Input</b>", self._text), Paragraph("<b>Output</b>", self._text)],
            [Preformatted(text, self._code) for text in texts],
        ]
        table = Table(rows, colWidths=[self._width / 2] * 2, repeatRows=1)
        table.setStyle(
            [
                ("BOX", (0, 0), (-1, -1), 0.5, colors.grey),
                ("LINEAFTER", (0, 0), (0, -1), 0.5, colors.grey),
                ("VALIGN", (0, 0), (-1, -1), "TOP"),
            ]
        )
        return table


def _inline(nodes: Iterable[Node]) -> str:
    return "".join(_phrase(node) for node in nodes)


def _phrase(node: Node) -> str:
    """Return a node in the small markup that reportlab's paragraphs read."""
    match node.type:
        case "inline":
            return _inline(node.children)
        case "text":
            return escape(node.content)
        case "softbreak":
            return " "
        case "strong":
            return f"<b>{_inline(node.children)}</b>"
        case "em":
            return f"<i>{_inline(node.children)}</i>"
        case "code_inline":
            return f'<font face="Courier">{escape(node.content)}</font>'
        case "math_inline":
            formula = FORMULA.sub(r"\1<sub>\2</sub>", escape(node.content))
            return f"<i>{formula}</i>"
    raise StatementError(f"problem.md:{line_of(node)}: {node.type}: no PDF form is known")
