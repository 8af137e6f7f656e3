"""What judging one tiny case costs beyond the program: `python -m bench.overhead`.

The same program is run in a bare loop, by a keeper alone, and by a keeper behind the wall,
in turn, so that whatever else the machine does affects all alike. While a judge compares an
output, the keeper builds the next wall ahead; here it does so while the others run. So the
wall is measured once more at once after itself, when the next one is not built yet.
"""

from __future__ import annotations

import argparse
import statistics
import subprocess
import time
from collections.abc import Callable, Sequence

from judge.kit.command import Parser, run, whole_number
from judge.sandbox.facts import RunLimits
from judge.sandbox.probe import walled_sandbox
from judge.sandbox.sandbox import Command, Sandbox

PROGRAM = "/bin/true"
LIMITS = RunLimits(time_limit_s=5.0, memory_mib=256, output_mib=1)
WARM_UP_RUNS = 3
MEASURED = 0


def main(arguments: Sequence[str]) -> int:
    """Print the medians; return 0, or 2 when no wall works here."""

    def command() -> int:
        parser = Parser(
            prog="python -m bench.overhead",
            description=__doc__,
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        parser.add_argument(
            "--runs", type=whole_number(1), default=50, help="of each kind (default 50)"
        )
        _print(_times_ms(parser.parse_args(arguments).runs))
        return MEASURED

    return run("overhead", command)


def _times_ms(runs: int) -> dict[str, list[float]]:
    """Return the milliseconds of each run, by kind. Raises NoWallError."""
    with Sandbox() as alone, walled_sandbox() as walled:
        kinds: dict[str, Callable[[], object]] = {
            "bare loop": lambda: subprocess.run([PROGRAM], stdin=subprocess.DEVNULL, check=True),
            "keeper": lambda: _run_in(alone),
            "keeper and wall": lambda: _run_in(walled),
            "wall, at once": lambda: _run_in(walled),
        }
        times_ms: dict[str, list[float]] = {kind: [] for kind in kinds}
        for number in range(WARM_UP_RUNS + runs):
            for kind, once in kinds.items():
                started = time.perf_counter()
                once()
                if number >= WARM_UP_RUNS:
                    times_ms[kind].append((time.perf_counter() - started) * 1000)
    return times_ms


def _run_in(sandbox: Sandbox) -> None:
    sandbox.run(Command((PROGRAM,)), LIMITS, stdout=sandbox.scratch / "output")


def _print(times_ms: dict[str, list[float]]) -> None:
    bare_ms = statistics.median(times_ms["bare loop"])
    for kind, all_ms in times_ms.items():
        median_ms = statistics.median(all_ms)
        print(
            f"{kind:16} median {median_ms:6.2f} ms, least {min(all_ms):6.2f} ms, "
            f"median over the bare loop {median_ms - bare_ms:6.2f} ms"
        )
