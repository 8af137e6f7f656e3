"""Draw scenarios: `python -m pictures figures`, `python -m pictures show FILE.in 3 -o a.svg`."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path

from judge.kit.command import Parser, run
from judge.kit.files import FileError, check_place, write_report, write_whole
from judge.kit.paths import DATA, ROOT
from pictures.draw import picture
from pictures.explain import explain_picture
from pictures.lesson import lesson_figures
from pictures.read import ReadError, read_scenarios

FIGURES = ROOT / "docs" / "figures"
DONE, STALE = 0, 1


def main(arguments: Sequence[str]) -> int:
    """Run the command line; return the exit status: 0 done, 1 out of date, 2 usage."""

    def command() -> int:
        options = _options(arguments)
        if options.command == "figures":
            return draw_figures(check=options.check)
        return show_scenario(options.file, options.scenario, options.output)

    return run("pictures", command)


def _options(arguments: Sequence[str]) -> argparse.Namespace:
    parser = Parser(prog="python -m pictures", description=__doc__)
    commands = parser.add_subparsers(dest="command", required=True)
    figures = commands.add_parser(
        "figures", help="draw the figures of the statement and the lesson"
    )
    figures.add_argument("--check", action="store_true", help="only tell whether they are current")
    show = commands.add_parser("show", help="print the picture of one scenario as SVG")
    show.add_argument("file", type=Path, help="an input file")
    show.add_argument("scenario", type=int, help="its number, counted from 1")
    show.add_argument("-o", "--output", type=Path, metavar="FILE", help="write the picture here")
    return parser.parse_args(arguments)


def sample_figures() -> dict[Path, str]:
    """Return the statement's figures: path to SVG text, one for each sample."""
    return {
        FIGURES / f"{sample.stem}.svg": sample_picture(sample)
        for sample in sorted((DATA / "sample").glob("*.in"))
    }


def sample_picture(sample: Path) -> str:
    """Return the picture of all scenarios of one sample, with their answers."""
    scenarios = read_scenarios(sample)
    answers = sample.with_suffix(".ans").read_text().split()
    captions = [f"scenario {i}: {answer}" for i, answer in enumerate(answers, 1)]
    return picture(scenarios, captions)


def draw_figures(*, check: bool) -> int:
    """Write the figures that are out of date; with `check`, only name them.

    Return the exit status.
    """
    lesson = {FIGURES / name: svg for name, svg in lesson_figures().items()}
    stale = {
        path: svg
        for path, svg in (sample_figures() | lesson).items()
        if not path.exists() or path.read_text() != svg
    }
    for path, svg in stale.items():
        if check:
            print(f"{path.relative_to(ROOT)} is not current: run 'make figures'")
        else:
            write_whole(path, svg.encode())
            print(f"drawn: {path.relative_to(ROOT)}")
    return STALE if check and stale else DONE


def show_scenario(file: Path, number: int, output: Path | None) -> int:
    """Print or write the picture that explains one scenario. Return the exit status.

    Raises ReadError, FileError.
    """
    check_place("--output", output)
    if output is not None and output.suffix not in ("", ".svg"):
        raise FileError(
            f"--output {output}: expected a name that ends with .svg, found {output.suffix}: "
            "only SVG is written"
        )
    scenarios = read_scenarios(file)
    if not 1 <= number <= len(scenarios):
        raise ReadError(f"{file}: there is no scenario {number}, expected 1 to {len(scenarios)}")
    title = f"{file.name}, scenario {number}"
    svg = explain_picture(scenarios[number - 1], title=title)
    if output is None:
        print(svg, end="")
    else:
        write_report("--output", output, svg.encode)
    return DONE
