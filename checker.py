#!/usr/bin/env python3
"""Judges a submission: compiles, runs, limits, compares, scores. More than an output validator.

    ./checker.py SUBMISSION        ./checker.py < my.py        ./checker.py --help

Any Python 3 may start it: outside the kit's own environment it hands over to that.
What it does stands in judge/; its command line in judge/cli.py.
"""

import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent
ENVIRONMENT = ROOT / ".venv"


def main() -> int:
    """Return the exit status: 0 accepted, 1 not, 2 usage or judge error, 130 interrupted."""
    python = ENVIRONMENT / "bin" / "python"
    if os.path.lexists(python) and not os.access(python, os.X_OK):
        print(f"checker.py: {python} cannot be executed by this user", file=sys.stderr)
        return 2
    if Path(sys.prefix).resolve() != ENVIRONMENT.resolve() and os.access(python, os.X_OK):
        os.execv(python, [str(python), str(ROOT / "checker.py"), *sys.argv[1:]])
    try:
        from judge.cli import main as judge_main
    except (ImportError, SyntaxError):  # no packages, or a Python older than the kit's
        print("checker.py: the kit is not set up: run 'make setup' first", file=sys.stderr)
        return 2
    return judge_main()


if __name__ == "__main__":
    sys.exit(main())
