"""The plain zip: `oj test` of online-judge-tools judges the reference with it."""

from __future__ import annotations

import shlex
import sys

from export.verify.job import Job, find_tool, run_tool
from judge.kit.paths import REFERENCE

QUICK_FILES = "test/sample-*"


def verify(job: Job) -> list[str]:
    """Run the reference on the unpacked files. quick: on the samples only. Raises VerifyError."""
    job.unpack()
    files = sorted(map(str, job.scratch.glob(QUICK_FILES if job.quick else "test/*")))
    command = f"{shlex.quote(sys.executable)} {shlex.quote(str(REFERENCE))}"
    run_tool([find_tool("oj"), "test", "--command", command, *files], job.scratch)
    return [f"oj test: {len(files) // 2} cases accepted"]
