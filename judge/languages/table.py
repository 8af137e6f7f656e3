"""The languages a submission may be written in: how to recognise, compile and run each."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from judge.kit.errors import KitError
from judge.kit.paths import ROOT
from judge.kit.text import did_you_mean
from judge.sandbox.sandbox import Command

SYSTEM_PATH = "/usr/local/bin:/usr/bin:/bin"


class LanguageError(KitError):
    """The language is not known, or its tools are not installed; one clear line."""


@dataclass(frozen=True, slots=True)
class Language:
    """One language.

    tools: the programs it needs, compiler first. compile, run: arguments where
    `{tool}` is the path of a needed program, `{source}` the source file's name and
    `{main}` what is run, its stem but for Java; both run in the directory of the
    source; `{dir}` is that directory, `{heap_mib}` what the memory limit leaves for a
    managed heap.
    hints: any of these in the text tells the language (see `guess`).
    """

    name: str
    suffixes: tuple[str, ...]
    tools: tuple[str, ...]
    compile: tuple[str, ...]
    run: tuple[str, ...]
    hints: re.Pattern[str]


def _hints(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern, re.MULTILINE)


_CPP_WORDS = (
    r"#\s*include\s*<(?:bits/stdc\+\+\.h|\w+)>"  # C's headers end in .h
    r"|\busing\s+namespace\b|\bstd::|\btemplate\s*<"
)

_PYTHON_BLOCK = _hints(
    r"^(?:import|from)\s+\w[\w.]*(?:\s+import\b.*|\s+as\s+\w+|\s*,.*)?$"
    r"|^\s*(?:def|class|for|while|if|with|try)\b.*:\s*(?:#.*)?$"
)
_STATEMENT_END = _hints(r"[;{]\s*(?://.*)?$|^\s*package\s+main\b")

GUESS_CHARS = 1 << 20  # more than any problem allows

# In the order in which they are tried on a text without a file name.
LANGUAGES: tuple[Language, ...] = (
    Language(
        "Rust",
        (".rs",),
        ("rustc",),
        ("{rustc}", "--edition=2021", "-O", "-o", "{dir}/{main}", "{dir}/{source}"),
        ("{dir}/{main}",),
        _hints(r"^\s*(?:pub\s+)?fn\s+main\s*\(\s*\)|^\s*use\s+std::"),
    ),
    Language(
        "C++",
        (".cpp", ".cc", ".cxx", ".c++"),
        ("g++",),
        ("{g++}", "-std=gnu++20", "-O2", "-pipe", "-o", "{dir}/{main}", "{dir}/{source}"),
        ("{dir}/{main}",),
        _hints(_CPP_WORDS),
    ),
    Language(
        "C",
        (".c",),
        ("gcc",),
        ("{gcc}", "-std=gnu17", "-O2", "-pipe", "-o", "{dir}/{main}", "{dir}/{source}", "-lm"),
        ("{dir}/{main}",),
        _hints(r"^\s*#\s*include\s*[<\"]"),
    ),
    Language(
        "Java",
        (".java",),
        ("javac", "java"),
        ("{javac}", "-encoding", "UTF-8", "-nowarn", "-d", "{dir}", "{dir}/{source}"),
        (
            "{java}",
            "-XX:+UseSerialGC",
            "-XX:-UsePerfData",  # it would write below the system's temporary directory
            "-Xss64m",
            "-Xmx{heap_mib}m",
            "-cp",
            "{dir}",
            "{main}",
        ),
        _hints(r"\bpublic\s+static\s+void\s+main\b|^\s*import\s+java\."),
    ),
    Language(
        "Go",
        (".go",),
        ("go",),
        ("{go}", "build", "-o", "{dir}/{main}", "{dir}/{source}"),
        ("{dir}/{main}",),
        _hints(r"^\s*package\s+main\b"),
    ),
    Language(
        "JavaScript",
        (".js", ".mjs", ".cjs"),
        ("node",),
        ("{node}", "--check", "{dir}/{source}"),
        ("{node}", "--stack-size=60000", "{dir}/{source}"),
        _hints(
            r"^#!.*\bnode\b|\brequire\s*\(\s*['\"]|\bprocess\.stdin\b|\bconsole\.log\b"
            r"|^\s*(?:const|let|var)\s+\w+\s*="
        ),
    ),
    Language(
        "Python 3",
        (".py", ".py3"),
        ("python3",),
        ("{python3}", "-I", "-m", "py_compile", "{dir}/{source}"),
        ("{python3}", "-I", "-B", "{dir}/{source}"),
        _hints(
            r"^#!.*\bpython|^\s*(?:import|from)\s+\w+|^\s*def\s+\w+\s*\(|^\s*print\s*\("
            r"|\binput\s*\(|^\s*for\s+\w+.*:\s*$"
        ),
    ),
    Language(
        "PyPy 3",
        (".pypy",),
        ("pypy3",),
        ("{pypy3}", "-I", "-m", "py_compile", "{dir}/{source}"),
        ("{pypy3}", "-I", "-B", "{dir}/{source}"),
        _hints(r"^#!.*\bpypy"),
    ),
)


def by_name(name: str) -> Language:
    """Return the language called `name`, case and spaces aside (`python`, `C++`, `pypy3`, `cpp`).

    Raises LanguageError with the known names.
    """
    wanted = _plain(name)
    for language in LANGUAGES:
        plain = _plain(language.name)
        if wanted in {plain, plain.rstrip("3"), *(s.removeprefix(".") for s in language.suffixes)}:
            return language
    names = [language.name for language in LANGUAGES]
    near = did_you_mean(wanted, [_plain(n) for n in names])
    raise LanguageError(f"unknown language {name!r}{near}; expected one of {', '.join(names)}")


def by_suffix(path: Path) -> Language | None:
    """Return the language of a file's suffix, None if no language has it."""
    for language in LANGUAGES:
        if path.suffix.lower() in language.suffixes:
            return language
    return None


def guess(text: str) -> Language | None:
    """Return the language that the text itself tells, None if nothing does.

    A `#!` line decides first; then whether it looks like Python, whose comments and
    strings may hold anything; then the languages in their order, as the hints of the
    later ones also occur in texts of the earlier ones. Only the first GUESS_CHARS count;
    linear time.
    """
    # The hints allow any white space; where there is never more than one, they are linear.
    lines = (re.sub(r"\s+", " ", line).rstrip() for line in text[:GUESS_CHARS].split("\n"))
    text = "\n".join(line for line in lines if line)
    first = text[: text.find("\n")] if text.startswith("#!") else ""
    if "pypy" in first:
        return by_name("PyPy 3")
    if "python" in first:
        return by_name("Python 3")
    if _PYTHON_BLOCK.search(text) and not _STATEMENT_END.search(text):
        return by_name("Python 3")
    for language in LANGUAGES:
        if language.hints.search(text):
            return language
    return None


@dataclass(frozen=True, slots=True)
class Toolchain:
    """A language with the paths of its programs, and the environment and files they need."""

    language: Language
    paths: dict[str, str]
    env: dict[str, str]
    prefixes: tuple[str, ...]

    def compile_command(self, directory: Path, source: str) -> Command:
        """Return the command that compiles `source` in `directory`."""
        return self._command(self.language.compile, directory, source, Path(source).stem, 0)

    def run_command(self, directory: Path, source: str, main: str, memory_mib: int) -> Command:
        """Return the command that runs `main` of what was compiled, within `memory_mib`."""
        return self._command(self.language.run, directory, source, main, memory_mib)

    def _command(
        self, template: tuple[str, ...], directory: Path, source: str, main: str, memory_mib: int
    ) -> Command:
        words = {
            **{f"{{{tool}}}": path for tool, path in self.paths.items()},
            "{dir}": str(directory),
            "{source}": source,
            "{main}": main,
            "{heap_mib}": str(memory_mib * 7 // 8),
        }
        argv = tuple(re.sub(r"\{[^}]+\}", lambda m: words[m[0]], part) for part in template)
        return Command(argv, self.env, prefixes=self.prefixes)


def toolchain(language: Language, which: Callable[[str], str | None] = shutil.which) -> Toolchain:
    """Find the programs of a language. Raises LanguageError naming the missing one."""
    paths: dict[str, str] = {}
    for tool in language.tools:
        path = _own_python() if tool == "python3" else which(tool)
        if path is None:
            raise LanguageError(f"{language.name}: {tool!r} is not installed (not found in PATH)")
        paths[tool] = _behind_rustup(path) if tool == "rustc" else path
    env = {"PATH": SYSTEM_PATH, "LANG": "C.UTF-8", "PYTHONIOENCODING": "utf-8"}
    if language.name == "Go":
        env |= {"GO111MODULE": "off", "CGO_ENABLED": "0", "GOCACHE": "/tmp/go", "GOFLAGS": ""}
    prefixes = {_prefix(Path(path)) for path in paths.values()} - {None}
    return Toolchain(language, paths, env, tuple(sorted(map(str, prefixes))))


def _prefix(tool: Path) -> Path | None:
    """Return the directory that a tool outside the system needs; None for the system's own."""
    real = tool.resolve()
    if real.is_relative_to("/usr") or real.is_relative_to("/bin"):
        return None
    prefix = real.parent.parent
    holds_more = any(place.is_relative_to(prefix) for place in (ROOT, Path.home()))
    return real.parent if holds_more else prefix


def _own_python() -> str:
    """The interpreter behind the virtual environment: one Python for the kit and submissions."""
    return os.path.realpath(sys.executable)


def _behind_rustup(path: str) -> str:
    """Return the compiler itself: rustup's stand-in of that name needs a home directory."""
    try:
        asked = subprocess.run(
            [path, "--print", "sysroot"], capture_output=True, text=True, timeout=30, check=True
        )
    except (OSError, subprocess.SubprocessError):
        return path
    compiler = Path(asked.stdout.strip()) / "bin" / "rustc"
    return str(compiler) if compiler.is_file() else path


def _plain(name: str) -> str:
    return name.lower().replace(" ", "").replace("c++", "cpp")
