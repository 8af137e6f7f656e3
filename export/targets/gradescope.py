"""Gradescope: the zip of an autograder.

setup.sh runs once, when Gradescope builds the image; run_autograder runs for each submission.
Source: https://gradescope-autograders.readthedocs.io/en/latest/specs/
"""

from __future__ import annotations

from autograder.results import broken
from export.files import Files
from export.kit import Parts, kit_files
from export.package import Package
from export.target import Target

MIB = 1 << 20
PARTS = Parts(
    rooms=("autograder", "gen", "judge", "pictures", "stress"),
    files=(
        "solution.py",
        "brute.py",
        "submissions/accepted/separating_axis.py",  # what confirms answers
        "submissions/accepted/textbook.py",
    ),
)
# Replaced at the end of a judging; what stays if Gradescope ends it before.
UNFINISHED = "the judging did not end: out of time, out of memory, or setup.sh failed"

SETUP = """\
#!/usr/bin/env bash
# Builds the image: compilers, the kit's environment, the large test cases from their seeds.
# For submissions in other languages, add to the packages: rustc golang-go nodejs pypy3.
set -euo pipefail
export PYTHON=python3
if [ -z "${AUTOGRADER_NO_APT:-}" ]; then
  export DEBIAN_FRONTEND=noninteractive
  install() { apt-get install -y -qq --no-install-recommends "$@"; }
  apt-get update -qq
  install g++ default-jdk-headless python3 python3-venv
  install bubblewrap || echo "no bubblewrap here; the kit brings its own"
  if ! python3 -c 'import sys; sys.exit(sys.version_info < (3, 11))'; then
    install python3.11 python3.11-venv  # Ubuntu 22.04
    PYTHON=python3.11
  fi
fi
bash "${AUTOGRADER:-/autograder}/source/kit/prepare.sh"
"""

RUN = """\
#!/usr/bin/env bash
# Judges what lies in submission/ and writes results/results.json.
root="${AUTOGRADER:-/autograder}"
mkdir -p "$root/results"
cp "$root/source/unfinished.json" "$root/results/results.json"
exec python3 "$root/source/kit/autograder" "$root"
"""


def build(package: Package) -> Files:
    """Lay out setup.sh, run_autograder, what run_autograder leaves if it is ended, and the kit."""
    files = kit_files(package, PARTS)
    files.add("setup.sh", SETUP, executable=True)
    files.add("run_autograder", RUN, executable=True)
    files.add("unfinished.json", broken(UNFINISHED))
    return files


TARGETS = (
    Target(
        name="gradescope",
        title="Gradescope, programming assignment",
        build=build,
        import_it=(
            "Make a programming assignment of 100 points, upload this zip at Configure Autograder "
            "(Ubuntu 22.04 or newer), and give it 1 CPU and 2 GB or more at Settings."
        ),
        max_bytes=100 * MIB,
    ),
)
