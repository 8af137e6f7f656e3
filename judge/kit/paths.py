"""The root directory of the kit, and the paths of its main files."""

from __future__ import annotations

from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROBLEM_FILE = ROOT / "problem.toml"
DATA = ROOT / "data"
BUILD = ROOT / "build"  # made by commands, never committed; may be deleted at any time
SUBMISSIONS = ROOT / "submissions"
REFERENCE = ROOT / "solution.py"
VALIDATOR = ROOT / "gen" / "validator.py"
BRUTE_FORCE = ROOT / "brute.py"
EXPLORER = ROOT / "docs" / "explorer.html"
