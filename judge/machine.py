"""How fast this machine is, compared with the one on which the time limit was set.

The reference is timed on the calibration case; a slower machine gives every program
proportionally more time. The speed belongs to the machine and not to the moment, so it is kept
with a description of the machine until `make calibrate` is run.
"""

from __future__ import annotations

import contextlib
import datetime
import platform
from pathlib import Path

import msgspec

from judge.kit.checksums import Checksums
from judge.kit.errors import KitError
from judge.kit.files import write_whole
from judge.kit.paths import BUILD, DATA, REFERENCE
from judge.languages.submission import CompileError, compile_submission, read_submission
from judge.problem.cases import Case, case_at
from judge.problem.data import check_unchanged
from judge.problem.declaration import Problem
from judge.problem.manifest import load_manifest
from judge.problem.verdict import Verdict
from judge.results import Scale
from judge.run import declared_limits, run_case
from judge.sandbox.sandbox import Sandbox

KEPT = BUILD / "machine.json"
LIMIT_FACTOR = 100.0  # if the reference is slower than this, something is broken
LEAST_RUNS, MOST_RUNS = 3, 12
AGREEMENT = 1.02  # the greatest ratio of the two fastest runs: then neither was disturbed
UNCALIBRATED = "not scaled to this machine: no reference here, or no calibration case"


class MachineError(KitError):
    """The speed of this machine cannot be measured."""


class Description(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What decides how fast the reference runs, apart from the current load."""

    processor: str
    kernel: str
    python: str
    reference_sha256: str
    calibration_cpu_s: float


class Kept(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The content of `build/machine.json`. measured: the date."""

    machine: Description
    scale: float
    measured: str


def kept_scale(problem: Problem, path: Path = KEPT) -> Scale | None:
    """Return the scale that was kept for this machine, None if there is none."""
    try:
        kept = msgspec.json.decode(path.read_bytes(), type=Kept)
    except (OSError, msgspec.DecodeError, UnicodeDecodeError):
        return None
    if kept.machine != describe(problem):
        return None
    return Scale(kept.scale, f"measured on {kept.measured}, kept until 'make calibrate'")


def measure_scale(problem: Problem, sandbox: Sandbox, path: Path = KEPT) -> Scale | None:
    """Time the reference; keep and return the scale. None: it or its case is not there.

    Raises MachineError if the reference fails, CasesError, SandboxError.
    """
    if not (calibration_case(problem).input.is_file() and REFERENCE.is_file()):
        return None
    declared_s = problem.calibration.reference_cpu_s
    measured_s = reference_cpu_s(problem, sandbox, enough_s=declared_s)
    factor = round(max(1.0, measured_s / declared_s), 4)
    today = datetime.datetime.now(datetime.UTC).date().isoformat()
    kept = Kept(describe(problem), factor, today)
    with contextlib.suppress(OSError):  # then it is measured again next time
        content = msgspec.json.format(msgspec.json.encode(kept), indent=2) + b"\n"
        write_whole(path, content, parents=True)
    return Scale(factor, "measured now by the reference's time")


def scale_of(problem: Problem, sandbox: Sandbox) -> float:
    """Return the scale of this machine, kept or measured; 1 if it cannot be measured."""
    scale = kept_scale(problem) or measure_scale(problem, sandbox)
    return 1.0 if scale is None else scale.factor


def forget_scale(path: Path = KEPT) -> None:
    """Delete the scale that was kept. Raises OSError."""
    path.unlink(missing_ok=True)


def describe(problem: Problem) -> Description:
    """Return the description of this machine and of the reference."""
    return Description(
        processor=_processor(),
        kernel=platform.release(),
        python=platform.python_version(),
        reference_sha256=Checksums().sha256(REFERENCE),
        calibration_cpu_s=problem.calibration.reference_cpu_s,
    )


def _processor() -> str:
    """Return the kernel's name of the processor; on some machines only its architecture."""
    with contextlib.suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.machine()


def calibration_case(problem: Problem) -> Case:
    """Return the calibration case; its files may not be built."""
    return case_at(DATA, problem.calibration.case)


def reference_cpu_s(problem: Problem, sandbox: Sandbox, enough_s: float = 0.0) -> float:
    """Return the CPU seconds of the reference on the calibration case: the least of some runs.

    Disturbances only add time, so the least counts. Runs are repeated until the two fastest
    agree or one takes at most `enough_s`, but at most MOST_RUNS times. Raises MachineError if
    the reference fails, CasesError if the case differs from the manifest.
    """
    case = calibration_case(problem)
    check_unchanged(load_manifest(DATA), [case], DATA, Checksums())
    try:
        reference = compile_submission(read_submission(REFERENCE), problem.limits, sandbox)
    except CompileError as error:
        raise MachineError(f"the reference does not compile: {error}") from None
    limits = declared_limits(problem.limits, problem.calibration.reference_cpu_s * LIMIT_FACTOR)
    times_s: list[float] = []
    while len(times_s) < MOST_RUNS:
        result = run_case(sandbox, reference, limits, case)
        if result.verdict is not Verdict.AC:
            raise MachineError(
                f"the reference is not accepted on {case.name}: {result.verdict} {result.message}"
            )
        times_s = sorted([*times_s, result.cpu_s])
        if times_s[0] <= enough_s:
            break
        if len(times_s) >= LEAST_RUNS and times_s[1] <= times_s[0] * AGREEMENT:
            break
    return times_s[0]
