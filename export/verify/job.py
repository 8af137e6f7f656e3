"""What every verification is given, and how it finds and runs the judges' own tools."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from judge.kit.errors import KitError
from judge.kit.paths import BUILD
from judge.kit.text import printable_name

JUDGES = BUILD / "judges"  # the environment of the judges' tools
TIMEOUT_S = 4 * 3600.0
SHOWN_LINES, SHOWN_CHARS = 30, 200


class VerifyError(KitError):
    """A package is not what its judge's tools expect, or a tool is missing."""


@dataclass(frozen=True, slots=True)
class Job:
    """One verification.

    package: the zip or directory of the target. scratch: an empty directory. quick: leave out
    what takes minutes: LaTeX, submissions, thousands of random files.
    """

    package: Path
    scratch: Path
    quick: bool

    @property
    def python(self) -> Path:
        """The Python of the judges' tools. Raises VerifyError if there is none."""
        return find_tool("python")

    def unpack(self) -> Path:
        """Unpack the zip into the scratch directory; return the directory that it holds."""
        with zipfile.ZipFile(self.package) as archive:
            archive.extractall(self.scratch)
        entries = list(self.scratch.iterdir())
        return entries[0] if len(entries) == 1 and entries[0].is_dir() else self.scratch


def find_tool(name: str) -> Path:
    """Return a program of the judges' environment. Raises VerifyError: it says what to run."""
    path = JUDGES / "bin" / name
    if not os.access(path, os.X_OK):
        raise VerifyError(f"{path}: this tool is missing; run 'python3 tools/setup.py --judges'")
    return path


def need(program: str, package: str) -> None:
    """Raise VerifyError unless a program of the system is there. package: Debian's, with it."""
    if shutil.which(program) is None:
        raise VerifyError(f"{program} is missing; on Debian and Ubuntu: apt install {package}")


def show_end(text: str) -> None:
    """Print the last lines of a tool's output on standard error."""
    for line in text.strip().splitlines()[-SHOWN_LINES:]:
        print(printable_name(line, SHOWN_CHARS), file=sys.stderr)


def run_tool(command: Sequence[str | Path], directory: Path, *, must_succeed: bool = True) -> str:
    """Run a judge's tool in a directory; return what it printed.

    The tool finds the programs of its own environment, and keeps its files beside the directory:
    BAPCtools remembers every problem in the user's configuration, and warns of equal ones. If the
    tool must succeed and fails, the end of what it printed goes to standard error. Raises
    VerifyError.
    """
    name = Path(command[0]).name
    own = directory.parent / "tool"
    own.mkdir(exist_ok=True)
    environment = os.environ | {
        "PATH": f"{JUDGES / 'bin'}{os.pathsep}{os.environ.get('PATH', os.defpath)}",
        "NO_COLOR": "1",
        "TMPDIR": str(own),
        "XDG_CONFIG_HOME": str(own),
    }
    try:
        run = subprocess.run(
            command,
            cwd=directory,
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            timeout=TIMEOUT_S,
            check=False,
        )
    except subprocess.TimeoutExpired:
        raise VerifyError(f"{name}: still running after {TIMEOUT_S:,.0f} s") from None
    text = run.stdout.decode(errors="replace")
    if run.returncode and must_succeed:
        show_end(text)
        raise VerifyError(f"{name}: expected exit status 0, found {run.returncode}")
    return text
