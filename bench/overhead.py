"""What judging one tiny case costs beyond the program: `python -m bench.overhead`.

The same program is run in a bare loop, by a keeper alone, and by a keeper behind the
wall, in turn, so that what else the machine does touches all three alike.
"""

from __future__ import annotations

import argparse
import statistics
import subprocess
import sys
import time
from collections.abc import Callable

from judge.sandbox.facts import RunLimits
from judge.sandbox.probe import probe
from judge.sandbox.sandbox import Command, Sandbox

PROGRAM = "/bin/true"
LIMITS = RunLimits(time_limit_s=5.0, memory_mib=256, output_mib=1)
WARM_UP_RUNS = 3


def main() -> int:
    """Print the medians; return 0, or 2 when no wall stands."""
    parser = argparse.ArgumentParser(prog="python -m bench.overhead", description=__doc__)
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument("--runs", type=int, default=50, help="of each kind (default 50)")
    runs = parser.parse_args().runs
    found = probe()
    if found.wall is None:
        print(f"overhead: no wall stands: {found.why}", file=sys.stderr)
        return 2
    with Sandbox() as alone, Sandbox(found.wall) as walled:
        kinds: dict[str, Callable[[], object]] = {
            "bare loop": lambda: subprocess.run([PROGRAM], stdin=subprocess.DEVNULL, check=True),
            "keeper": lambda: run(alone),
            "keeper and wall": lambda: run(walled),
        }
        times_ms: dict[str, list[float]] = {kind: [] for kind in kinds}
        for number in range(WARM_UP_RUNS + runs):
            for kind, once in kinds.items():
                started = time.perf_counter()
                once()
                if number >= WARM_UP_RUNS:
                    times_ms[kind].append((time.perf_counter() - started) * 1000)
    bare_ms = statistics.median(times_ms["bare loop"])
    for kind, all_ms in times_ms.items():
        median_ms = statistics.median(all_ms)
        print(
            f"{kind:16} median {median_ms:6.2f} ms, least {min(all_ms):6.2f} ms, "
            f"median over the bare loop {median_ms - bare_ms:6.2f} ms"
        )
    return 0


def run(sandbox: Sandbox) -> None:
    sandbox.run(Command((PROGRAM,)), LIMITS, stdout=sandbox.scratch / "output")


if __name__ == "__main__":
    sys.exit(main())
