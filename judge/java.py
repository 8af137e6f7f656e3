"""What a Java source is called: its file, and the class whose `main` is run."""

from __future__ import annotations

import re

# Comments and literals may hold anything, braces and the word `class` too.
_NO_CODE = re.compile(
    r"//[^\n]*|/\*.*?\*/|\"\"\".*?\"\"\"|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])+'", re.DOTALL
)
_TYPE = re.compile(r"\b(public\b[^{};]*?)?\b(?:class|interface|enum|record)\s+(\w+)")
_MAIN = re.compile(r"\bstatic\b[^(){};=]*\bvoid\s+main\s*\(")


def java_names(text: str) -> tuple[str, str]:
    """Return the stem of the file that javac wants, and the full name of the class to run.

    The file is named after the public top-level class, `Main` if there is none. The
    class to run is the top-level one that holds `static void main`. O(len(text)).

    >>> java_names("class Main { static class Edge {} public static void main(String[] a) {} }")
    ('Main', 'Main')
    >>> java_names("package a.b; class X {} public class Y { static void main(String[] a) {} }")
    ('Y', 'a.b.Y')
    """
    code = _NO_CODE.sub(" ", text)
    package = re.search(r"^\s*package\s+([\w.]+)\s*;", code, re.MULTILINE)
    stem = main = None
    for public, name, body in _top_level_types(code):
        if public and stem is None:
            stem = name
        if main is None and _MAIN.search(body):
            main = name
    stem = stem or "Main"
    main = main or stem
    return stem, f"{package[1]}.{main}" if package else main


def _top_level_types(code: str) -> list[tuple[bool, str, str]]:
    """Return every top-level type: whether it is public, its name, its body."""
    found = []
    at = 0
    while (declared := _TYPE.search(code, at)) is not None:
        opening = code.find("{", declared.end())
        if opening < 0:
            break
        at = _end_of_block(code, opening)
        found.append((declared[1] is not None, declared[2], code[opening:at]))
    return found


def _end_of_block(code: str, opening: int) -> int:
    """Return the index behind the brace that closes the one at `opening`."""
    depth = 0
    for brace in re.finditer(r"[{}]", code[opening:]):
        depth += 1 if brace[0] == "{" else -1
        if depth == 0:
            return opening + brace.end()
    return len(code)
