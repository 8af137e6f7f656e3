"""A language's tools on this machine, and the commands that compile and run with them."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from judge.kit.paths import ROOT
from judge.languages.table import Language, LanguageError
from judge.sandbox.sandbox import Command

SYSTEM_PATH = "/usr/local/bin:/usr/bin:/bin"
ISOLATED = ".python"  # in the program's directory


@dataclass(frozen=True, slots=True)
class Toolchain:
    """A language with the paths of its tools, and the environment and files they need."""

    language: Language
    paths: dict[str, str]
    env: dict[str, str]
    prefixes: tuple[str, ...]

    def prepare(self, directory: Path) -> None:
        """Add to a program's directory what its commands need besides the source.

        For an isolated Python, that is a virtual environment without packages: three entries.
        `site` works as usual in it, and finds only the standard library. Raises OSError.
        """
        if self.language.isolated_python:
            interpreter = Path(self.paths[self.language.tools[0]])
            (directory / ISOLATED / "bin").mkdir(parents=True)
            settings = f"home = {interpreter.parent}\ninclude-system-site-packages = false\n"
            (directory / ISOLATED / "pyvenv.cfg").write_text(settings)
            (directory / ISOLATED / "bin" / self.language.tools[0]).symlink_to(interpreter)

    def compile_command(self, directory: Path, source: str) -> Command:
        """Return the command that compiles `source` in `directory`."""
        return self._command(self.language.compile, directory, source, Path(source).stem, 0)

    def run_command(self, directory: Path, source: str, main: str, memory_mib: int) -> Command:
        """Return the command that runs the compiled program or class `main`."""
        return self._command(self.language.run, directory, source, main, memory_mib)

    def _command(
        self, template: tuple[str, ...], directory: Path, source: str, main: str, memory_mib: int
    ) -> Command:
        paths = self.paths
        if self.language.isolated_python:
            paths = {tool: str(directory / ISOLATED / "bin" / tool) for tool in paths}
        words = {
            **{f"{{{tool}}}": path for tool, path in paths.items()},
            "{dir}": str(directory),
            "{source}": source,
            "{main}": main,
            "{heap_mib}": str(memory_mib * 7 // 8),
        }
        argv = tuple(re.sub(r"\{[^}]+\}", lambda m: words[m[0]], part) for part in template)
        return Command(argv, self.env, prefixes=self.prefixes)


def toolchain(language: Language, which: Callable[[str], str | None] = shutil.which) -> Toolchain:
    """Find the tools of a language. Raises LanguageError naming the missing one."""
    paths: dict[str, str] = {}
    for tool in language.tools:
        path = _own_python() if tool == "python3" else which(tool)
        if path is None:
            raise LanguageError(f"{language.name}: {tool!r} is not installed (not found in PATH)")
        paths[tool] = _behind_rustup(path) if tool == "rustc" else path
    env = {"PATH": SYSTEM_PATH, "LANG": "C.UTF-8", "PYTHONIOENCODING": "utf-8", **language.env}
    prefixes = {needed for tool, path in paths.items() for needed in _needed(tool, Path(path))}
    return Toolchain(language, paths, env, tuple(sorted(map(str, prefixes))))


def _needed(tool: str, path: Path) -> list[Path]:
    """Return what must be shown of a tool outside the system: its own tree, or single files.

    A tree that holds more than the tool, such as ~/.local, is not shown; of a Python that is
    installed there, its standard library is. (What else such a tool needs there is missing.)
    """
    real = path.resolve()
    if real.is_relative_to("/usr") or real.is_relative_to("/bin"):
        return []
    prefix, home = real.parent.parent, Path.home()
    holds_more = any(place.is_relative_to(prefix) for place in (ROOT, home))
    if not holds_more and prefix not in (home / ".local", Path("/opt"), Path("/")):
        return [prefix]
    library = [Path(sysconfig.get_path("stdlib"))] if tool == "python3" else []
    return [real, *library]


def _own_python() -> str:
    """Return the interpreter behind the virtual environment: submissions run on it, too."""
    return os.path.realpath(sys.executable)


def _behind_rustup(path: str) -> str:
    """Return the real compiler, not rustup's proxy, which needs a home directory."""
    try:
        asked = subprocess.run(
            [path, "--print", "sysroot"], capture_output=True, text=True, timeout=30, check=True
        )
    except (OSError, subprocess.SubprocessError):
        return path
    compiler = Path(asked.stdout.strip()) / "bin" / "rustc"
    return str(compiler) if compiler.is_file() else path
