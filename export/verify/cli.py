"""`python -m export verify`: the judges' own tools read the packages back."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from export.package import load_package
from export.verify import classroom, cms, domjudge, gradescope, kattis, plain, polygon
from export.verify import verdicts as table
from export.verify.job import Job
from export.write import MIB, chosen, write
from judge.kit.command import Parser, add_jobs
from judge.kit.paths import BUILD
from judge.kit.processors import processors
from judge.kit.progress import progress_bar

VERIFIED = 0
# By target. Judges without a tool that runs elsewhere have none.
VERIFIERS: Mapping[str, Callable[[Job], list[str]]] = {
    "bapctools": kattis.verify_bapctools,
    "classroom": classroom.verify,
    "cms": cms.verify,
    "domjudge": domjudge.verify_job,
    "gradescope": gradescope.verify,
    "kattis": kattis.verify_legacy,
    "kattis-pass-fail": kattis.verify_legacy,
    "plain": plain.verify,
    "polygon": polygon.verify,
}


def verdicts(arguments: Sequence[str]) -> int:
    """Write docs/verdicts.md; return 0 if every submission has the same verdict everywhere."""
    parser = Parser(
        prog="python -m export verdicts",
        description="Judge every submission here and with the judges' own tools, and write the "
        "table of verdicts, docs/verdicts.md. Takes the better part of an hour on an idle machine.",
    )
    add = parser.add_argument
    add("--kattis", type=Path, metavar="FILE", help="what verifyproblem printed, instead of a run")
    add("--bapctools", type=Path, metavar="FILE", help="what 'bt run -B' printed, with --kattis")
    add_jobs(parser, processors(), "submissions judged")
    options = parser.parse_args(arguments)
    if (options.kattis is None) != (options.bapctools is None):
        parser.error("expected both --kattis and --bapctools, or none")
    package = load_package()
    if options.kattis is not None:
        printed = table.Printed(*(_text(path) for path in (options.kattis, options.bapctools)))
        return table.compare(package, printed, options.jobs)
    with tempfile.TemporaryDirectory(prefix="verify-", dir=BUILD) as name:
        return table.compare(package, table.run_tools(package, Path(name)), options.jobs)


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8", errors="replace")


def command(arguments: Sequence[str]) -> int:
    """Write each package anew, and verify it; return 0. Raises VerifyError at the first fault."""
    parser = Parser(
        prog="python -m export verify",
        description="Write packages, and let the judges' own tools read them back.",
    )
    add = parser.add_argument
    add("target", nargs="+", help="which; 'all' means all that a tool can read")
    add("--compact", action="store_true", help="only the cases of data/compact.json")
    add("--quick", action="store_true", help="leave out LaTeX and the judging of submissions")
    options = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory(prefix="verify-", dir=BUILD) as name:
        for target in chosen(options.target):
            verify = VERIFIERS.get(target.name)
            if verify is None:
                print(f"{target.name}: no tool of this judge runs here")
                continue
            scratch = Path(name) / target.name
            scratch.mkdir()
            package = load_package(compact=options.compact or target.compact)
            path, size = write(target, package, Path(name) / "packages")
            print(f"{target.name}: {size / MIB:,.1f} MiB", flush=True)
            with progress_bar(f"verifying {target.name}"):
                told = verify(Job(path, scratch, options.quick))
            for line in told:
                print(f"  {line}", flush=True)
    return VERIFIED
