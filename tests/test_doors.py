"""Every command starts with any Python, from any directory."""

import subprocess
import sys
from pathlib import Path

import pytest

from judge.kit.paths import ROOT

COMMANDS = ("autograder", "gen", "explorer", "pictures", "stress", "strength", "bench", "judge")
FILES = ("checker.py", "bench/fairness.py", "bench/overhead.py")


def outside():
    """Return a Python outside the kit's environment, as a user may have; None if there is none."""
    for place in (sys.base_prefix, "/usr", "/usr/local"):
        python = Path(place) / "bin" / "python3"
        if python.exists() and not python.is_relative_to(ROOT):
            return str(python)
    return None


def helped(*arguments, directory):
    """Run a command with a Python other than the kit's; return its help."""
    python = outside()
    if python is None or not (ROOT / ".venv").is_dir():
        pytest.skip("no Python outside of the kit's environment, or no environment")
    command = [python, *arguments, "--help"]
    done = subprocess.run(command, cwd=directory, capture_output=True, text=True, check=False)
    assert done.stderr == ""
    assert done.returncode == 0
    return done.stdout


@pytest.mark.parametrize(
    "command", [*COMMANDS, "bench.fairness", "bench.overhead", "judge.calibrate"]
)
def test_a_command_starts_as_a_module_in_the_kit(command):
    assert helped("-m", command, directory=ROOT).startswith("usage: ")


@pytest.mark.parametrize("file", [*COMMANDS, *FILES])
def test_a_command_starts_by_its_path_from_anywhere(file, tmp_path):
    assert helped(str(ROOT / file), directory=tmp_path).startswith("usage: ")
