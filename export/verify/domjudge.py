"""DOMjudge's own importer reads the package, under php-cli and without a database.

`php/import.php` says what is DOMjudge's code and what stands in for the rest.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import zipfile
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

import msgspec

from export.formats import layout
from export.package import load_package
from export.verify.job import Job, VerifyError
from judge.problem.declaration import load
from judge.problem.verdict import Verdict

CHECKOUT = "COLLISION_COURSE_DOMJUDGE"  # the environment variable with the path of a checkout
HARNESS = Path(__file__).with_name("php") / "import.php"
IMPORTER = "webapp/src/Service/ImportProblemService.php"
MEMORY = "memory_limit=4G"  # the importer holds all test cases at once
TIMEOUT_S = 900.0
DEBIAN = (
    "php-cli php-bcmath php-mbstring php-xml php-zip php-doctrine-collections "
    "php-symfony-http-kernel php-symfony-property-access php-symfony-security-core "
    "php-symfony-validator php-symfony-yaml"
)
# DOMjudge's words for the verdicts.
WORDS = {
    Verdict.AC: "CORRECT",
    Verdict.WA: "WRONG-ANSWER",
    Verdict.TLE: "TIMELIMIT",
    Verdict.RTE: "RUN-ERROR",
    Verdict.CE: "COMPILER-ERROR",
}


class Messages(msgspec.Struct):
    """What the importer tells the jury."""

    info: list[str] = []
    warning: list[str] = []
    danger: list[str] = []


class ImportedCase(msgspec.Struct):
    """A test case as DOMjudge holds it. name: the path below data/sample or data/secret."""

    name: str
    rank: int
    sample: bool
    md5_input: str
    md5_output: str
    description: str | None
    image: str | None


class ImportedProblem(msgspec.Struct):
    """A problem as DOMjudge holds it."""

    name: str
    external_id: str
    short_name: str
    time_limit_s: float
    memory_kib: int
    output_kib: int
    types: str
    compare: str | None
    statement_type: str
    statement_bytes: int
    test_cases: list[ImportedCase]


class ImportedSubmission(msgspec.Struct):
    """A submission of the jury. expected: in DOMjudge's words."""

    name: str
    language: str
    expected: list[str] | None


class Imported(msgspec.Struct):
    """All that an import made. problem: None if the package was refused."""

    messages: Messages
    problem: ImportedProblem | None
    submissions: list[ImportedSubmission]


def missing() -> str:
    """Return what is missing for DOMjudge's importer to run here, with the remedy; or ""."""
    if shutil.which("php") is None:
        return f"php is missing; on Debian: apt install {DEBIAN}"
    path = os.environ.get(CHECKOUT)
    if not path:
        return f"{CHECKOUT} is not set; expected the path of a checkout of DOMjudge"
    if not (Path(path) / IMPORTER).is_file():
        return f"{CHECKOUT}={path}: expected a checkout of DOMjudge, found no {IMPORTER}"
    return ""


def verify_job(job: Job) -> list[str]:
    """Import the package of a job. Without php or a checkout of DOMjudge: say what is missing."""
    why = missing()
    return [f"not verified: {why}"] if why else verify(job.package, job.scratch, checkout())


def checkout() -> Path:
    """Return the checkout of DOMjudge that the environment names."""
    return Path(os.environ[CHECKOUT])


def verify(package: Path, scratch: Path, domjudge: Path) -> list[str]:
    """Import a zip; return what DOMjudge then holds, in a few lines.

    scratch: an empty directory. domjudge: a checkout. Raises VerifyError with every warning of
    the importer, and with everything that is not as in the package.
    """
    found = read_back(package, scratch, domjudge)
    faults = [*found.messages.danger, *found.messages.warning]
    if found.problem is None:
        raise VerifyError(f"{package.name}: refused: {'; '.join(faults)}")
    faults += [*_problem_faults(found.problem), *_case_faults(found.problem, package)]
    faults += _submission_faults(found.submissions)
    if faults:
        raise VerifyError(f"{package.name}: {'; '.join(faults)}")
    cases = found.problem.test_cases
    samples = sum(case.sample for case in cases)
    return [
        f"DOMjudge's importer: no warning; {found.problem.external_id}: "
        f"{found.problem.time_limit_s:g} s, {found.problem.memory_kib} KiB, "
        f"statement {found.problem.statement_type} of {found.problem.statement_bytes:,} bytes",
        f"{samples} sample and {len(cases) - samples} secret cases, "
        f"{sum(bool(case.description) for case in cases)} with a description, "
        f"{sum(bool(case.image) for case in cases)} with an image; "
        f"{len(found.submissions)} submissions with the expected result",
    ]


def read_back(package: Path, scratch: Path, domjudge: Path) -> Imported:
    """Let DOMjudge's importer read a zip. Raises VerifyError if it fails."""
    command = ["php", "-d", MEMORY, *map(str, (HARNESS, domjudge, package, scratch))]
    try:
        done = subprocess.run(command, capture_output=True, timeout=TIMEOUT_S, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise VerifyError(f"php: {error}") from None
    try:
        return msgspec.json.decode(done.stdout, type=Imported)
    except msgspec.DecodeError:
        said = (done.stderr + done.stdout).decode(errors="replace").strip().partition("\n")[0]
        raise VerifyError(f"php: {said or f'exit status {done.returncode}'}") from None


def _problem_faults(found: ImportedProblem) -> Iterator[str]:
    problem = load()
    limits = problem.limits
    for what, expected, is_there in (
        ("name", problem.name, found.name),
        ("external id", problem.short_name, found.external_id),
        ("short name", problem.short_name, found.short_name),
        ("time limit", limits.time_limit_s, found.time_limit_s),
        ("memory limit", limits.memory_mib * 1024, found.memory_kib),
        ("output limit", limits.output_mib * 1024, found.output_kib),
        ("types", "pass-fail", found.types),
        ("comparison", None, found.compare),
        ("statement", "pdf", found.statement_type),
    ):
        if expected != is_there:
            yield f"{what}: expected {expected}, found {is_there}"


def _case_faults(found: ImportedProblem, package: Path) -> Iterator[str]:
    """Yield the cases whose place, content, description or image is not as in the zip."""
    with zipfile.ZipFile(package) as archive:
        names = set(archive.namelist())
        inputs = sorted(n for n in names if n.startswith("data/") and n.endswith(".in"))
        if len(inputs) != len(found.test_cases):
            yield f"test cases: expected {len(inputs)}, found {len(found.test_cases)}"
        for rank, (name, case) in enumerate(zip(inputs, found.test_cases, strict=False), 1):
            stem = name.removesuffix(".in")
            kind = PurePosixPath(name).parts[1]
            expected = (
                rank,
                stem.removeprefix(f"data/{kind}/"),
                kind == "sample",
                hashlib.md5(archive.read(name), usedforsecurity=False).hexdigest(),
                hashlib.md5(archive.read(f"{stem}.ans"), usedforsecurity=False).hexdigest(),
                f"{stem}.desc" in names,
                "svg" if f"{stem}.svg" in names else None,
            )
            is_there = (
                case.rank,
                case.name,
                case.sample,
                case.md5_input,
                case.md5_output,
                bool(case.description),
                case.image,
            )
            if expected != is_there:
                yield f"{name}: expected {expected}, found {is_there}"


def _submission_faults(found: list[ImportedSubmission]) -> Iterator[str]:
    """Yield each submission whose expected result is not the declared one."""
    expected = {
        each.file: [WORDS[verdict] for verdict in layout.coarse(each.overall)]
        for each in load_package().submissions
        if len(layout.coarse(each.overall)) == 1
    }
    held = {each.name: each.expected for each in found}
    for name in sorted(expected | held):
        if expected.get(name) != held.get(name):
            yield f"{name}: expected {expected.get(name)}, found {held.get(name)}"
