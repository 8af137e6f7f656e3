#!/usr/bin/env python3
"""Make the kit's own environment, .venv, with what pyproject.toml asks for.

Needs nothing but Python and, once, a package index. Run again, it repairs and
updates. Exit status: 0 ready, 2 not, with one line that says what to do.
"""

import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
VENV = ROOT / ".venv"
READY = VENV / ".ready"  # written last: without it the environment is not complete
MINIMUM = (3, 11)


def main() -> int:
    """Make the environment and return the exit status."""
    if sys.version_info < MINIMUM:
        return fail(
            f"Python {MINIMUM[0]}.{MINIMUM[1]} or newer is needed, this is "
            f"{sys.version_info[0]}.{sys.version_info[1]} ({sys.executable}); "
            "name another: make PYTHON=python3.12 ..."
        )
    READY.unlink(missing_ok=True)
    python = VENV / "bin" / "python"
    if not works(python):
        shutil.rmtree(VENV, ignore_errors=True)
        print("setup: making .venv", flush=True)
        made = subprocess.run([sys.executable, "-m", "venv", str(VENV)], capture_output=True)
        if made.returncode or not works(python):
            shutil.rmtree(VENV, ignore_errors=True)
            return fail(
                "this Python cannot make virtual environments; "
                "on Debian and Ubuntu: apt install python3-venv"
            )
    print("setup: installing what pyproject.toml asks for", flush=True)
    pip = [str(python), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    installed = subprocess.run([*pip, *requirements()], capture_output=True, text=True)
    if installed.returncode:
        errors = [line for line in installed.stderr.splitlines() if line.startswith("ERROR")]
        return fail(f"pip could not install: {(errors or ['no message'])[-1]}")
    READY.touch()
    return 0


def works(python: Path) -> bool:
    """Tell whether this is an interpreter that runs, is new enough and has pip."""
    check = f"import sys, pip; sys.exit(sys.version_info < {MINIMUM})"
    try:
        return subprocess.run([str(python), "-c", check], capture_output=True).returncode == 0
    except OSError:
        return False


def requirements() -> list[str]:
    """Return what the kit needs to run and to be tested, as pyproject.toml lists it."""
    import tomllib  # not at the top: older Pythons must get as far as our message

    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    return [*project["project"]["dependencies"], *project["dependency-groups"]["dev"]]


def fail(message: str) -> int:
    """Print the one line, and return the exit status."""
    print(f"setup: {message}", file=sys.stderr)
    return 2


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(fail("interrupted; run it again"))
