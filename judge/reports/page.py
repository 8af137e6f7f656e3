"""Renders the kit's HTML pages: one file each, without scripts, fonts or network.

Templates are Jinja's, as escaping is its default; every page extends `base.html`.
"""

from __future__ import annotations

from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined

from judge.kit.text import printable_name

TEMPLATES = Path(__file__).with_name("templates")
LINE_CHARS = 100_000


def render(template: str, folder: Path = TEMPLATES, **values: object) -> str:
    """Return the page that a template of `folder` makes of these values.

    Whatever a value holds is text: markup is escaped, unprintable characters are shown as codes.
    """
    environment = Environment(
        loader=FileSystemLoader([folder, TEMPLATES]),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        finalize=_printable,
        keep_trailing_newline=True,
    )
    return environment.get_template(template).render(values)


def _printable(value: object) -> object:
    """Return a plain string with its unprintable characters, except line ends, as codes."""
    if type(value) is not str:
        return value
    return "\n".join(printable_name(line, LINE_CHARS) for line in value.split("\n"))
