"""Build docs/explorer.html from its sources, the samples and the gallery.

`python -m explorer` writes the page; with --check it only tells whether the page is current.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from explorer.page import build
from explorer.scenes import gallery, samples
from judge.kit.command import Parser, run
from judge.kit.files import write_whole
from judge.kit.paths import ROOT
from judge.problem import declaration

PAGE = ROOT / "docs" / "explorer.html"
DONE, STALE = 0, 1


def main(arguments: Sequence[str]) -> int:
    """Run the command line; return the exit status: 0 done, 1 out of date, 2 usage."""

    def command() -> int:
        options = _options(arguments)
        page = build([*samples(), *gallery()], declaration.load().constraints).encode()
        return check(options.output, page) if options.check else write(options.output, page)

    return run("explorer", command)


def _options(arguments: Sequence[str]) -> argparse.Namespace:
    parser = Parser(prog="python -m explorer", description=__doc__)
    parser.add_argument("--check", action="store_true", help="only tell whether it is current")
    parser.add_argument("--output", type=Path, default=PAGE, help="the page (docs/explorer.html)")
    return parser.parse_args(arguments)


def check(file: Path, page: bytes) -> int:
    """Tell whether the file is this page. Return the exit status."""
    if file.exists() and file.read_bytes() == page:
        return DONE
    print(f"{file} is not current: run 'python -m explorer'")
    return STALE


def write(file: Path, page: bytes) -> int:
    """Write the page. Return the exit status."""
    write_whole(file, page)
    print(f"{file}: written, {len(page):,} bytes")
    return DONE
