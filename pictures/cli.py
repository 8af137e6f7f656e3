"""Draw scenarios: `python -m pictures figures`, `python -m pictures show FILE.in 3 > scene.svg`."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from judge.kit.command import run
from judge.kit.files import write_whole
from judge.kit.paths import ROOT
from pictures.draw import picture
from pictures.read import ReadError, read_scenarios

FIGURES = ROOT / "docs" / "figures"


def main() -> int:
    """Run the command line; return the exit status: 0 done, 1 out of date, 2 usage."""
    parser = argparse.ArgumentParser(prog="python -m pictures", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    figures = commands.add_parser("figures", help="draw the statement's figures, from the samples")
    figures.add_argument("--check", action="store_true", help="only tell whether they are current")
    show = commands.add_parser("show", help="print the picture of one scenario as SVG")
    show.add_argument("file", type=Path, help="an input file")
    show.add_argument("scenario", type=int, help="its number, counted from 1")
    arguments = parser.parse_args()

    def command() -> int:
        if arguments.command == "figures":
            return draw_figures(check=arguments.check)
        return show_scenario(arguments.file, arguments.scenario)

    return run("pictures", command, (ReadError,))


def sample_figures() -> dict[Path, str]:
    """Return the statement's figures: path to SVG text, one for each sample."""
    return {
        FIGURES / f"{sample.stem}.svg": sample_picture(sample)
        for sample in sorted((ROOT / "data" / "sample").glob("*.in"))
    }


def sample_picture(sample: Path) -> str:
    """Return the picture of all scenarios of one sample, with their answers."""
    scenarios = read_scenarios(sample)
    answers = sample.with_suffix(".ans").read_text().split()
    captions = [f"scenario {i}: {answer}" for i, answer in enumerate(answers, 1)]
    return picture(scenarios, captions)


def draw_figures(*, check: bool) -> int:
    """Write what has changed; with `check`, only say so. Return the exit status."""
    stale = {
        path: svg
        for path, svg in sample_figures().items()
        if not path.exists() or path.read_text() != svg
    }
    for path, svg in stale.items():
        if check:
            print(f"{path.relative_to(ROOT)} is not current: run 'make figures'")
        else:
            write_whole(path, svg.encode())
            print(f"drawn: {path.relative_to(ROOT)}")
    return 1 if check and stale else 0


def show_scenario(file: Path, number: int) -> int:
    """Print one scenario's picture. Return the exit status."""
    scenarios = read_scenarios(file)
    if not 1 <= number <= len(scenarios):
        raise ReadError(f"{file}: there is no scenario {number}, expected 1 to {len(scenarios)}")
    print(picture([scenarios[number - 1]], [f"{file.name}, scenario {number}"]), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
