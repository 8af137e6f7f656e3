"""Kattis packages: `verifyproblem` of problemtools, and `bt` of BAPCtools."""

from __future__ import annotations

import re
from pathlib import Path

from export.formats.yaml import as_yaml
from export.verify.job import Job, VerifyError, find_tool, need, run_tool, show_end

RESULT = re.compile(r"tested: (\d+) errors?, (\d+) warnings?")
FAULTS = ("ERROR", "WARNING")
QUICK_PARTS = ("config", "data", "validators")


def take_any_java(directory: Path) -> None:
    """Let problemtools compile Java with whatever JDK is here; by itself, it asks for Java 21.

    directory: the problem's parent, where problemtools looks for settings.
    """
    java = {"compile": "javac -encoding UTF-8 -sourcepath {path} -d {path} {files}"}
    (directory / "languages.yaml").write_text(as_yaml({"java": java}), encoding="utf-8")


def verify_legacy(job: Job) -> list[str]:
    """Let verifyproblem check a package in the legacy format: no error, no warning.

    In full, it also typesets the statement and judges every submission. Raises VerifyError.
    """
    problem = job.unpack()
    command: list[str | Path] = [find_tool("verifyproblem"), problem.name]
    if job.quick:
        command += ["-p", *QUICK_PARTS]
    else:
        need("lualatex", "texlive-latex-extra texlive-luatex texlive-fonts-recommended")
        need("pypy3", "pypy3")  # problemtools runs Python submissions with it
        take_any_java(problem.parent)
    text = run_tool(command, problem.parent)
    (job.scratch / "verifyproblem.txt").write_text(text, encoding="utf-8")
    found = RESULT.search(text)
    if found is None or found.groups() != ("0", "0"):
        show_end("\n".join(line for line in text.splitlines() if line.startswith(FAULTS)) or text)
        raise VerifyError("verifyproblem: expected 0 errors and 0 warnings")
    parts = ", ".join(QUICK_PARTS) if job.quick else "all parts"
    return [f"verifyproblem, {parts}: {found[1]} errors, {found[2]} warnings"]


def verify_bapctools(job: Job) -> list[str]:
    """Let BAPCtools validate a package in format 2025-09; in full, also judge the submissions.

    Raises VerifyError.
    """
    problem = job.unpack()
    bt = find_tool("bt")
    run_tool([bt, "validate", "--no-bar"], problem)
    told = ["bt validate: exit status 0"]
    if not job.quick:
        text = run_tool([bt, "run", "--no-bar"], problem)
        (job.scratch / "bt.txt").write_text(text, encoding="utf-8")
        told.append("bt run: exit status 0")
    return told
