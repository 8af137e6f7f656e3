"""The language table: names, suffixes, and the guess for a text without a name."""

from __future__ import annotations

from pathlib import Path

import pytest

from judge.kit.paths import ROOT
from judge.languages.guess import guess
from judge.languages.submission import SubmissionError, from_source, read_submission
from judge.languages.table import LANGUAGES, LanguageError, by_name, by_suffix
from judge.languages.toolchain import toolchain

SOURCES = sorted(p for p in (ROOT / "submissions").rglob("*.*") if by_suffix(p))

HELLO = {
    "C": '#include <stdio.h>\nint main(void) { puts("YES"); }\n',
    "C++": '#include <cstdio>\nint main() { puts("YES"); }\n',
    "Java": 'class A { public static void main(String[] a) { System.out.println("YES"); } }\n',
    "Rust": 'fn main() { let x = 1; println!("YES"); }\n',
    "Go": 'package main\n\nimport "fmt"\n\nfunc main() { fmt.Println("YES") }\n',
    "JavaScript": 'const lines = [];\nconsole.log("YES")\n',
    "Python 3": 'print("YES")\n',
    "PyPy 3": '#!/usr/bin/env pypy3\nprint("YES")\n',
}


@pytest.mark.parametrize("name", HELLO)
def test_a_text_tells_its_language(name: str) -> None:
    found = guess(HELLO[name])
    assert found is not None
    assert found.name == name


def test_every_language_has_such_a_text() -> None:
    assert set(HELLO) == {language.name for language in LANGUAGES}


def test_the_guess_for_every_submission_agrees_with_its_suffix() -> None:
    assert SOURCES
    for path in SOURCES:
        assert guess(path.read_text()) is by_suffix(path), path


def test_a_text_of_no_language() -> None:
    assert guess("to be or not to be\n") is None
    with pytest.raises(SubmissionError, match=r"standard input: .* guessed from .* --language"):
        from_source(b"to be or not to be\n", "standard input")


@pytest.mark.parametrize(
    ("given", "name"),
    [
        ("cpp", "C++"),
        ("c++", "C++"),
        ("C", "C"),
        ("python", "Python 3"),
        ("PY", "Python 3"),
        ("pypy3", "PyPy 3"),
        ("pypy", "PyPy 3"),
        ("js", "JavaScript"),
        ("rust", "Rust"),
    ],
)
def test_names(given: str, name: str) -> None:
    assert by_name(given).name == name


def test_an_unknown_name_gets_a_suggestion() -> None:
    with pytest.raises(LanguageError, match=r"unknown language 'pyhton3'; did you mean 'python3'"):
        by_name("pyhton3")


@pytest.mark.parametrize("name", HELLO)
def test_a_missing_compiler_is_named(name: str) -> None:
    language = by_name(name)
    if name == "Python 3":  # the kit's own interpreter is always there
        assert Path(toolchain(language, lambda _tool: None).paths["python3"]).is_file()
        return
    with pytest.raises(LanguageError, match=f"'{language.tools[0].replace('+', '.')}' is not inst"):
        toolchain(language, lambda _tool: None)


def test_bad_submissions(tmp_path: Path) -> None:
    (tmp_path / "empty.py").write_text(" \n")
    (tmp_path / "junk.cpp").write_bytes(b"\x7fELF\0\1")
    (tmp_path / "what.xyz").write_text("print()")
    for name, message in {
        "empty.py": "found nothing in it",
        "junk.cpp": "binary data .a zero byte at offset 4",
        "what.xyz": "expected a suffix among .* found '.xyz'",
        "": "found a directory",
        "none.py": "no such file",
    }.items():
        with pytest.raises(SubmissionError, match=message):
            read_submission(tmp_path / name)
