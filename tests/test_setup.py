"""An old Python can parse every file that a user starts, and says which Python is needed."""

from __future__ import annotations

import ast
import shutil
import subprocess
from pathlib import Path

import pytest

from judge.kit.paths import ROOT

DOORS = ["checker.py", "judge/kit/door.py", "judge/__init__.py", "judge/kit/__init__.py"]
DOORS += sorted(str(path.relative_to(ROOT)) for path in ROOT.glob("*/__main__.py"))
OLD = next((p for v in range(6, 11) if (p := shutil.which(f"python3.{v}"))), None)


@pytest.mark.parametrize("name", [*DOORS, "tools/setup.py"])
def test_an_old_python_can_parse_it(name: str) -> None:
    text = (ROOT / name).read_text()
    tree = ast.parse(text, feature_version=(3, 7))
    postponed = "from __future__ import annotations" in text
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    assert postponed or not any(
        f.returns or any(a.annotation for a in f.args.args) for f in functions
    )


def test_every_command_has_a_door() -> None:
    commands = {
        "autograder",
        "bench",
        "explorer",
        "export",
        "gen",
        "judge",
        "pictures",
        "stress",
        "strength",
    }
    assert {Path(name).parts[0] for name in DOORS if name.endswith("__main__.py")} == commands


def test_an_old_python_is_told_what_to_do() -> None:
    version = None if OLD is None else subprocess.run([OLD, "-c", ""], check=False).returncode
    if OLD is None or version:
        pytest.skip("no Python older than the kit's is installed")
    done = subprocess.run(
        [OLD, ROOT / "tools/setup.py"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    assert done.stderr.startswith("setup: Python 3.11 or newer is needed, this is 3.")
    assert done.stderr.count("\n") == 1
