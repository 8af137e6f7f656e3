"""`python -m bench.fairness`: do verdicts hold on a busy machine? See `bench.under_load`."""

import sys
from pathlib import Path

if __name__ == "__main__":
    sys.path[0] = str(Path(__file__).resolve().parents[1])
    from judge.kit.door import start

    start("bench.under_load", "bench/fairness.py")
