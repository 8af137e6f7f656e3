"""The statement's figures as PDF; the sources are the SVG files in docs/figures/."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

from export.statement.read import StatementError


def figure_pdf(svg: Path) -> bytes:
    """Return an SVG file as a PDF of one page. Equal drawings give equal bytes.

    Raises StatementError.
    """
    from reportlab import rl_config
    from reportlab.graphics import renderPDF
    from svglib.svglib import svg2rlg

    if not svg.is_file():
        raise StatementError(f"{svg}: the figure is missing; run 'make figures'")
    rl_config.invariant = 1  # no time of creation in the file
    drawing = svg2rlg(str(svg))
    if drawing is None:
        raise StatementError(f"{svg}: not a drawing that can be converted")
    stream = BytesIO()
    renderPDF.drawToFile(drawing, stream)
    return stream.getvalue()
