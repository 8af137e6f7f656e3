"""`python -m autograder`; or `python …/autograder`, from any directory."""

import sys
from pathlib import Path

if __name__ == "__main__":
    sys.path[0] = str(Path(__file__).resolve().parents[1])
    from judge.kit.door import start

    start("autograder.cli")
