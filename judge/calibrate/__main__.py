"""`python -m judge.calibrate`; or `python …/judge/calibrate`, from any directory."""

import sys
from pathlib import Path

if __name__ == "__main__":
    sys.path[0] = str(Path(__file__).resolve().parents[2])
    from judge.kit.door import start

    start("judge.calibrate.cli", "judge/calibrate")
