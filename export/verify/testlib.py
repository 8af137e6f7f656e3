"""Compiles the validator and the checker of a Polygon package, and asks them.

testlib.h comes with the package rbx-cp, in an environment of its own, because it is not the kit's.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from export.verify.job import VerifyError, need
from judge.kit.trusted import run_to_end, run_trusted

RESOURCES = "import importlib.util as u; print(u.find_spec('rbx').submodule_search_locations[0])"
TESTLIB = Path("resources", "predownloaded", "testlib.h")
OK, WRONG, BAD_FORMAT, FAIL = 0, 1, 2, 3  # testlib's exit statuses


def find_testlib(python: Path) -> Path:
    """Return the directory of testlib.h in the environment of a Python. Raises VerifyError."""
    run = run_to_end("testlib", (str(python), "-c", RESOURCES))
    path = Path(run.stdout.decode().strip()) / TESTLIB
    if run.returncode or not path.is_file():
        raise VerifyError(f"{python}: rbx-cp is missing; run 'python3 tools/setup.py --judges'")
    return path.parent


def compile_with(testlib: Path, source: Path, program: Path) -> Path:
    """Compile a C++ program for testlib and return it. Raises VerifyError, ProgramError."""
    need("g++", "g++")
    options = ("-std=gnu++20", "-O2", f"-I{testlib}", "-o", str(program))
    run_trusted(f"g++ {source.name}", ("g++", *options, str(source)))
    return program


@dataclass(frozen=True, slots=True)
class Validator:
    """A compiled validator."""

    program: Path

    def passes(self, content: bytes, group: str | None) -> bool:
        """Tell whether it passes an input. Raises VerifyError if it fails itself."""
        held = ("--testset", "tests", "--group", group) if group else ()
        run = run_to_end(self.program.name, (str(self.program), *held), content)
        if run.returncode not in (OK, FAIL):
            raise VerifyError(f"{self.program.name}: exit status {run.returncode}: {run.stderr!r}")
        return run.returncode == OK


@dataclass(frozen=True, slots=True)
class Checker:
    """A compiled checker, with a directory for the files that it reads."""

    program: Path
    scratch: Path

    def accepts(self, output: bytes, answer: bytes) -> bool:
        """Tell whether it accepts an output. Raises VerifyError if it fails itself."""
        paths = [self.scratch / name for name in ("input", "output", "answer")]
        for path, content in zip(paths, (b"", output, answer), strict=True):
            path.write_bytes(content)
        return self.status(paths) == OK

    def status(self, paths: Sequence[Path]) -> int:
        """Return its exit status for the paths of input, output and answer."""
        run = run_to_end(self.program.name, (str(self.program), *map(str, paths)))
        if run.returncode not in (OK, WRONG, BAD_FORMAT):
            raise VerifyError(f"{self.program.name}: exit status {run.returncode}: {run.stderr!r}")
        return run.returncode
