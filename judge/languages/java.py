"""Finds two names in a Java source: of its file, and of the class whose `main` is run."""

from __future__ import annotations

import re
from dataclasses import dataclass

# Comments and literals, which may hold braces and the word `class`. Unclosed ones match too:
# to search for a missing end from every possible start would be quadratic.
_NO_CODE = re.compile(
    r"//[^\n]*|/\*.*?(?:\*/|\Z)|\"\"\".*?(?:\"\"\"|\Z)"
    r"|\"(?:\\.|[^\"\\\n])*\"?|'(?:\\.|[^'\\\n])*'?",
    re.DOTALL,
)
_TOKEN = re.compile(r"[\w$]+|[.(){};=]")
_KINDS = {"class", "interface", "enum", "record"}
_LONGEST_STEM_BYTES = 240  # with `.java` or `.class`, still a valid file name


@dataclass(slots=True)
class _Type:
    """A top-level type, as far as it has been read."""

    name: str
    public: bool
    has_main: bool = False


def java_names(text: str) -> tuple[str, str]:
    """Return the stem of the file name that javac wants, and the full name of the class to run.

    The file is named after the public top-level class, `Main` if there is none. The
    class to run is the top-level one that holds `static void main`. O(len(text)).

    >>> java_names("class Main { static class Edge {} public static void main(String[] a) {} }")
    ('Main', 'Main')
    >>> java_names("package a.b; class X {} public class Y { static void main(String[] a) {} }")
    ('Y', 'a.b.Y')
    """
    package, types = _read(_TOKEN.findall(_NO_CODE.sub(" ", text)))
    stem = next((each.name for each in types if each.public), "Main")
    main = next((each.name for each in types if each.has_main), stem)
    if len(stem.encode()) > _LONGEST_STEM_BYTES:
        stem = "Main"  # the compiler will report the wrong name
    return stem, f"{package}.{main}" if package else main


def _read(tokens: list[str]) -> tuple[str, list[_Type]]:
    """Return the package, empty if there is none, and the top-level types, in one pass."""
    package, types = "", []
    depth = 0
    statement: list[str] = []  # tokens since the last brace or semicolon
    words: set[str] = set()  # tokens since the last sign other than a dot
    declared: _Type | None = None  # the type around the current token
    last = before = ""
    for token in tokens:
        if declared is None and last in _KINDS and before != ".":
            declared = _Type(token, "public" in statement)
            types.append(declared)
        if token == "(" and (before, last) == ("void", "main") and "static" in words and declared:
            declared.has_main = True
        if token == "{":
            depth += 1
        elif token == "}":
            depth = max(0, depth - 1)
            declared = declared if depth else None
        if token in "{};":
            if token == ";" and statement[:1] == ["package"]:
                package = "".join(statement[1:])
            statement = []
        else:
            statement.append(token)
        if token in "(){};=":
            words = set()
        else:
            words.add(token)
        before, last = last, token
    return package, types
