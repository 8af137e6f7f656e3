#!/usr/bin/env python3
"""Make the kit's environment, .venv, with the packages that pyproject.toml lists.

    python3 tools/setup.py            the packages for judging
    python3 tools/setup.py --export   also those for packages for other judges
    python3 tools/setup.py --dev      all, with those for tests and checks of the code
    python3 tools/setup.py --judges   the judges' own tools, in an environment apart: build/judges

It needs only Python and access to a package index. If it is run again, it repairs and
updates. Exit status: 0 ready; 2 not ready, with one line that says what to do.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent


class Kind(NamedTuple):
    """What may be asked for.

    what: ends the sentence "installing what ...". groups: of packages in pyproject.toml, beyond
    those for judging. marks: written last, they say that the environment is complete.
    """

    what: str
    groups: list[str]
    marks: list[str]
    environment: Path = ROOT / ".venv"
    judging: bool = True


KINDS = {
    "": Kind("judging needs", [], [".ready"]),
    "--export": Kind("exports need", ["export"], [".ready", ".ready-export"]),
    "--dev": Kind("the tests need", ["export", "dev"], [".ready", ".ready-export", ".ready-dev"]),
    "--judges": Kind("verifies exports", ["judges"], [".ready"], ROOT / "build" / "judges", False),
}
MINIMUM = (3, 11)
QUIET = ["--quiet", "--disable-pip-version-check", "--no-warn-script-location"]


def main() -> int:
    """Make the environment and return the exit status."""
    if sys.version_info < MINIMUM:
        return fail(
            f"Python {MINIMUM[0]}.{MINIMUM[1]} or newer is needed, this is "
            f"{sys.version_info[0]}.{sys.version_info[1]} ({sys.executable}); "
            "name another: make PYTHON=python3.12 ..."
        )
    option = " ".join(sys.argv[1:])
    if option not in KINDS:
        return fail(f"expected {', '.join(filter(None, KINDS))} or nothing, found {option}")
    kind = KINDS[option]
    environment = kind.environment
    python = environment / "bin" / "python"
    for mark in environment.glob(".ready*"):
        mark.unlink()
    if not works(python):
        shutil.rmtree(environment, ignore_errors=True)
        print(f"setup: making {environment.relative_to(ROOT)}", flush=True)
        made = run([sys.executable, "-m", "venv", "--without-pip", str(environment)])
        if made.returncode or not works(python):
            shutil.rmtree(environment, ignore_errors=True)
            return fail(
                "this Python cannot make virtual environments; "
                "on Debian and Ubuntu: apt install python3-venv"
            )
    pip = pip_command(python)
    if pip is None:
        return fail(
            "this Python has no pip and cannot install one; "
            "on Debian and Ubuntu: apt install python3-venv"
        )
    print(f"setup: installing what {kind.what}", flush=True)
    installed = run([*pip, "install", *QUIET, "--no-compile", *requirements(kind)])
    if installed.returncode:
        errors = [line for line in installed.stderr.splitlines() if line.startswith("ERROR")]
        return fail(f"pip could not install: {(errors or ['no message'])[-1]}")
    for name in kind.marks:
        (environment / name).touch()
    return 0


def run(command: list[str]) -> subprocess.CompletedProcess[str]:
    """Run a command to its end and return its status and output."""
    return subprocess.run(command, capture_output=True, text=True, check=False)


def works(python: Path) -> bool:
    """Tell whether the environment has an interpreter that runs and is new enough."""
    try:
        check = f"import sys; sys.exit(sys.version_info < {MINIMUM})"
        return run([str(python), "-c", check]).returncode == 0
    except OSError:
        return False


def pip_command(python: Path) -> list[str] | None:
    """Return the command of a pip that installs into the environment, None if there is none.

    The environment's own pip comes first. Otherwise this Python's pip installs from outside,
    which saves seconds. If it is missing or too old, ensurepip makes one inside.
    """
    outside = [sys.executable, "-m", "pip", "--python", str(python)]
    inside = [str(python), "-m", "pip"]
    if run([*inside, "--version"]).returncode == 0:
        return inside
    if run([*outside, "--version"]).returncode == 0:
        return outside
    if run([str(python), "-m", "ensurepip"]).returncode == 0:
        return inside
    return None


def requirements(kind: Kind) -> list[str]:
    """Return the packages that an environment needs, as pyproject.toml lists them."""
    import tomllib  # not at the top: on an older Python, our message comes first

    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    lists = [project["project"]["dependencies"]] if kind.judging else []
    lists += [project["dependency-groups"][group] for group in kind.groups]
    return [package for packages in lists for package in packages]


def fail(message: str) -> int:
    """Print the one line, and return the exit status."""
    print(f"setup: {message}", file=sys.stderr)
    return 2


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(fail("interrupted; run it again"))
