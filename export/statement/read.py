"""Reads problem.md into the parts that judges want apart."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from markdown_it import MarkdownIt
from markdown_it.tree import SyntaxTreeNode
from mdit_py_plugins.dollarmath import dollarmath_plugin

from judge.kit.errors import KitError

Node = SyntaxTreeNode
Nodes = tuple[Node, ...]
SAMPLES, GROUPS = "Samples", "Groups"


class StatementError(KitError):
    """The statement has a form that cannot be converted; the message names the line."""


@dataclass(frozen=True, slots=True)
class Section:
    """A part of the statement with its heading. title "": the story before the first heading."""

    title: str
    body: Nodes


@dataclass(frozen=True, slots=True)
class SampleNote:
    """What the statement says about one sample. title: `First scenes`."""

    title: str
    figure: Path
    body: Nodes


@dataclass(frozen=True, slots=True)
class Statement:
    """The statement. sections: all but the samples; before_notes: what holds for all samples.

    Inputs and outputs of samples are left out: judges print them themselves.
    """

    title: str
    sections: tuple[Section, ...]
    before_notes: Nodes
    notes: tuple[SampleNote, ...]

    def section(self, title: str) -> Section:
        """Return the section with a title. Raises StatementError."""
        for section in self.sections:
            if section.title == title:
                return section
        raise StatementError(f"expected a section {title!r}, found none")

    def without(self, *titles: str) -> tuple[Section, ...]:
        """Return all sections but these."""
        return tuple(section for section in self.sections if section.title not in titles)


def parser() -> MarkdownIt:
    """Return the parser of the statement's Markdown: with tables and $formulas$."""
    return MarkdownIt("commonmark").enable("table").use(dollarmath_plugin)


def read_statement(path: Path) -> Statement:
    """Parse the statement. Raises StatementError."""
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise StatementError(f"{path}: cannot be read: {error.strerror}") from None
    root = Node(parser().parse(text))
    title, sections = "", [Section("", ())]
    for node in root.children:
        if node.type == "heading" and node.tag == "h1":
            title = plain(node)
        elif node.type == "heading" and node.tag == "h2":
            sections.append(Section(plain(node), ()))
        else:
            last = sections.pop()
            sections.append(Section(last.title, (*last.body, node)))
    if not title:
        raise StatementError(f"{path}: expected a heading with the title, found none")
    samples = next((each.body for each in sections if each.title == SAMPLES), ())
    before, notes = _notes(samples, path)
    return Statement(
        title, tuple(each for each in sections if each.title != SAMPLES), before, notes
    )


def _notes(nodes: Nodes, path: Path) -> tuple[Nodes, tuple[SampleNote, ...]]:
    """Split the samples' section at its headings; leave out inputs and outputs."""
    parts: list[list[Node]] = [[]]
    for node in nodes:
        if node.type == "heading":
            parts.append([node])
        elif node.type != "fence" and plain(node) not in ("Input:", "Output:"):
            parts[-1].append(node)
    return tuple(parts[0]), tuple(_note(part, path) for part in parts[1:])


def _note(part: Sequence[Node], path: Path) -> SampleNote:
    heading, figure, *body = part
    image = next((node for node in figure.walk() if node.type == "image"), None)
    if image is None:
        raise StatementError(f"{path}:{line_of(heading)}: expected a figure below this heading")
    title = plain(heading).partition(": ")[2]
    return SampleNote(title, path.parent / str(image.attrs["src"]), tuple(body))


def plain(node: Node) -> str:
    """Return the text of a node without its markup."""
    return "".join(
        each.content for each in node.walk() if each.type in ("text", "code_inline", "math_inline")
    )


def line_of(node: Node) -> int:
    """Return the line of the nearest node that knows it, 0 if none does."""
    while node.map is None and node.parent is not None:
        node = node.parent
    return 0 if node.map is None else node.map[0] + 1
