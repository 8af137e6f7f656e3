"""`python -m bench.overhead`: what judging one tiny case costs. See `bench.launch_cost`."""

import sys
from pathlib import Path

if __name__ == "__main__":
    sys.path[0] = str(Path(__file__).resolve().parents[1])
    from judge.kit.door import start

    start("bench.launch_cost", "bench/overhead.py")
