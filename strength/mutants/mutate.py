"""Small changes to a Python program, each a bug that one could have written.

A change replaces the text of one syntax node, so a mutant differs from the original in one
place only. Annotations, docstrings and the last lines, which only call `main`, are left
alone: they decide no answer.
"""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

# Each operator, then what one might have written instead: with another boundary, or in the
# other direction.
COMPARISONS: dict[type[ast.cmpop], tuple[str, ...]] = {
    ast.Lt: ("<", "<=", ">", ">="),
    ast.LtE: ("<=", "<", ">=", ">"),
    ast.Gt: (">", ">=", "<", "<="),
    ast.GtE: (">=", ">", "<=", "<"),
    ast.Eq: ("==", "!=", "<=", ">="),
    ast.NotEq: ("!=", "==", "<", ">"),
    ast.Is: ("is", "is not"),
    ast.In: ("in", "not in"),
}
ARITHMETIC: dict[type[ast.operator], tuple[str, ...]] = {
    ast.Add: ("+", "-"),
    ast.Sub: ("-", "+"),
    ast.Mult: ("*", "+"),
    ast.FloorDiv: ("//", "*"),
    ast.Mod: ("%", "//"),
    ast.LShift: ("<<", ">>"),
    ast.RShift: (">>", "<<"),
}
NAMES = {
    "min": "max",
    "max": "min",
    "any": "all",
    "all": "any",
    "sorted": "list",
    "set": "list",
    "reversed": "list",
    "abs": "int",
    "bisect_left": "__import__('bisect').bisect_right",
}


@dataclass(frozen=True, slots=True)
class Mutant:
    """A program with one change.

    program: its path below the kit's root; function: the qualified name of the
    function changed, empty for the module; line: the lines that the change touches,
    stripped and joined; mutated: the same lines after it; nth: which of the changes with
    this description, from 1; number: the first line touched; source: the whole mutant.
    """

    program: str
    function: str
    line: str
    mutated: str
    nth: int
    number: int
    source: bytes

    @property
    def identity(self) -> tuple[str, str, str, str, int]:
        """What stays the same when lines of the program are moved."""
        return self.program, self.function, self.line, self.mutated, self.nth

    def __str__(self) -> str:
        times = f" ({self.nth})" if self.nth > 1 else ""
        where = f"{self.program}:{self.number}"
        return f"{where} {self.function or 'module'}: {self.line}  ->  {self.mutated}{times}"


@dataclass(frozen=True, slots=True)
class _Patch:
    start: int
    end: int
    text: str


class _Source:
    """A program's text in bytes, because positions of syntax nodes count bytes."""

    def __init__(self, content: bytes) -> None:
        self.content = content
        self.starts = [0]
        for line in content.splitlines(keepends=True):
            self.starts.append(self.starts[-1] + len(line))

    def start(self, node: Any) -> int:
        return self._offset(node.lineno, node.col_offset)

    def end(self, node: Any) -> int:
        return self._offset(node.end_lineno, node.end_col_offset)

    def _offset(self, line: int, column: int) -> int:
        return self.starts[line - 1] + column

    def text(self, node: ast.AST) -> str:
        return self.content[self.start(node) : self.end(node)].decode()

    def replaced(self, node: ast.AST, text: str) -> _Patch:
        return _Patch(self.start(node), self.end(node), text)

    def between(self, left: ast.AST, right: ast.AST, old: str, new: str) -> _Patch:
        """Replace the operator `old` between two operands, which may stand in brackets."""
        at = self.content.index(old.encode(), self.end(left), self.start(right))
        return _Patch(at, at + len(old), new)

    def lines(self, start: int, end: int) -> tuple[int, int, int]:
        """Return the number of the line at `start`, and the bounds of all lines touched."""
        first = max(i for i, at in enumerate(self.starts) if at <= start)
        last = min(at for at in self.starts if at >= end and at > start)
        return first + 1, self.starts[first], last


def mutants(program: str, content: bytes) -> list[Mutant]:
    """Return all mutants of a program in the order of their places, each text once.

    O(places * size). Raises SyntaxError if `content` is no Python program.
    """
    source = _Source(content)
    seen = {content}
    count: Counter[tuple[str, str, str]] = Counter()
    found = []
    for node, function in _nodes(ast.parse(content), ""):
        for patch in _patches(node, source):
            changed = content[: patch.start] + patch.text.encode() + content[patch.end :]
            if changed in seen:
                continue
            seen.add(changed)
            number, first, last = source.lines(patch.start, patch.end)
            longer = len(changed) - len(content)
            line, mutated = _flat(content[first:last]), _flat(changed[first : last + longer])
            count[function, line, mutated] += 1
            nth = count[function, line, mutated]
            found.append(Mutant(program, function, line, mutated, nth, number, changed))
    return found


def _flat(lines: bytes) -> str:
    """Return lines of code as one, without comments at their ends."""
    parts = [line.partition("  #")[0].strip() for line in lines.decode().splitlines()]
    return " ".join(parts)


def _nodes(node: ast.AST, function: str) -> Iterator[tuple[ast.AST, str]]:
    """Yield in order every node that may be changed, and the name of its function."""
    for child in _children(node):
        inside = function
        if isinstance(child, ast.FunctionDef | ast.ClassDef):
            inside = f"{function}.{child.name}".removeprefix(".")
        yield child, inside
        yield from _nodes(child, inside)


def _children(node: ast.AST) -> Iterator[ast.AST]:
    if _calls_main(node) or _is_docstring(node):
        return
    for name, value in ast.iter_fields(node):
        if name in ("annotation", "returns", "type_params"):
            continue
        for child in value if isinstance(value, list) else [value]:
            if isinstance(child, ast.AST):
                yield child


def _calls_main(node: ast.AST) -> bool:
    return isinstance(node, ast.If) and "__name__" in ast.unparse(node.test)


def _is_docstring(node: ast.AST) -> bool:
    return (
        isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
    )


def _patches(node: ast.AST, source: _Source) -> Iterator[_Patch]:
    for kind, rule in RULES:
        if isinstance(node, kind) and not _calls_main(node) and not _is_docstring(node):
            yield from rule(node, source)


def _comparison(node: ast.Compare, source: _Source) -> Iterator[_Patch]:
    operands = [node.left, *node.comparators]
    for left, operator, right in zip(operands, node.ops, operands[1:], strict=False):
        old, *others = COMPARISONS.get(type(operator), ("",))
        for new in others:
            yield source.between(left, right, old, new)


def _arithmetic(node: ast.BinOp, source: _Source) -> Iterator[_Patch]:
    old, *others = ARITHMETIC.get(type(node.op), ("",))
    for new in others:
        yield source.between(node.left, node.right, old, new)


def _augmented(node: ast.AugAssign, source: _Source) -> Iterator[_Patch]:
    old, *others = ARITHMETIC.get(type(node.op), ("",))
    for new in others:
        yield source.between(node.target, node.value, old, new)


def _boolean(node: ast.BoolOp, source: _Source) -> Iterator[_Patch]:
    old, new = ("and", "or") if isinstance(node.op, ast.And) else ("or", "and")
    for left, right in zip(node.values, node.values[1:], strict=False):
        yield source.between(left, right, old, new)


def _sign(node: ast.UnaryOp, source: _Source) -> Iterator[_Patch]:
    if isinstance(node.op, ast.USub):
        yield _Patch(source.start(node), source.start(node.operand), "")
    elif isinstance(node.op, ast.Not):
        yield _Patch(source.start(node), source.start(node), "not ")


def _constant(node: ast.Constant, source: _Source) -> Iterator[_Patch]:
    if isinstance(node.value, bool):
        yield source.replaced(node, str(not node.value))
    elif isinstance(node.value, int):
        yield source.replaced(node, str(node.value + 1))
        yield source.replaced(node, str(node.value - 1))
    elif isinstance(node.value, str):
        yield source.replaced(node, '""')


def _name(node: ast.Name, source: _Source) -> Iterator[_Patch]:
    if isinstance(node.ctx, ast.Load) and node.id in NAMES:
        yield source.replaced(node, NAMES[node.id])


def _condition(node: ast.If | ast.While | ast.IfExp, source: _Source) -> Iterator[_Patch]:
    if not isinstance(node.test, ast.Constant):
        yield source.replaced(node.test, "True")
        yield source.replaced(node.test, "False")


def _filters(node: ast.comprehension, source: _Source) -> Iterator[_Patch]:
    for test in node.ifs:
        yield source.replaced(test, "True")
        yield source.replaced(test, "False")


def _loop(node: ast.For, source: _Source) -> Iterator[_Patch]:
    yield source.replaced(node.iter, "()")


def _statement(node: ast.stmt, source: _Source) -> Iterator[_Patch]:
    yield source.replaced(node, "pass")


def _break(node: ast.Break, source: _Source) -> Iterator[_Patch]:
    yield source.replaced(node, "continue")


def _continue(node: ast.Continue, source: _Source) -> Iterator[_Patch]:
    yield source.replaced(node, "break")


def _subscript(node: ast.Subscript, source: _Source) -> Iterator[_Patch]:
    """Move an index or a bound by one, or leave a bound out. `_constant` moves constants."""
    if not isinstance(node.slice, ast.Slice):
        yield from _moved(node.slice, source)
        return
    for bound in (node.slice.lower, node.slice.upper, node.slice.step):
        if bound is not None:
            yield source.replaced(bound, "")
            yield from _moved(bound, source)


def _moved(index: ast.expr, source: _Source) -> Iterator[_Patch]:
    if isinstance(index, ast.Name | ast.BinOp | ast.Subscript | ast.Attribute):
        yield source.replaced(index, f"({source.text(index)} + 1)")
        yield source.replaced(index, f"({source.text(index)} - 1)")


# The rule for each kind of node. Any: each rule takes nodes of its own kind only.
RULES: tuple[tuple[Any, Callable[[Any, _Source], Iterator[_Patch]]], ...] = (
    (ast.Compare, _comparison),
    (ast.BinOp, _arithmetic),
    (ast.AugAssign, _augmented),
    (ast.BoolOp, _boolean),
    (ast.UnaryOp, _sign),
    (ast.Constant, _constant),
    (ast.Name, _name),
    ((ast.If, ast.While, ast.IfExp), _condition),
    (ast.comprehension, _filters),
    (ast.For, _loop),
    ((ast.Assign, ast.AugAssign, ast.AnnAssign, ast.Expr, ast.Return, ast.Raise), _statement),
    (ast.Break, _break),
    (ast.Continue, _continue),
    (ast.Subscript, _subscript),
)
