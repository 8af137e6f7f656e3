"""CMS packages: the checker against the kit's own judge, run as CMS runs it."""

from __future__ import annotations

from export.verify.job import Job, VerifyError, need
from export.verify.outputs import accepted, random_outputs
from judge.kit.trusted import run_trusted

SEED = 12
QUICK_COUNT, COUNT = 100, 2000


def verify(job: Job) -> list[str]:
    """Run the checker on random outputs. Raises VerifyError at the first difference."""
    need("/usr/bin/python3", "python3")  # its first line says so
    checker = job.unpack() / "check" / "checker"
    checker.chmod(0o755)
    paths = [job.scratch / name for name in ("input", "answer", "output")]
    count, right = QUICK_COUNT if job.quick else COUNT, 0
    for output, answer in random_outputs(SEED, count):
        for path, content in zip(paths, (b"", answer, output), strict=True):
            path.write_bytes(content)
        share = float(run_trusted("checker", (str(checker), *map(str, paths))))
        expected = accepted(output, answer)
        if share != expected:
            raise VerifyError(f"checker: {share} for output {output!r}, answer {answer!r}")
        right += expected
    return [f"checker: agrees on {count:,} random outputs ({right:,} of them right)"]
