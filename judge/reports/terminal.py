"""The report on the terminal: live progress, the table of groups, the first failure."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from rich.console import Console, JustifyMethod
from rich.table import Table
from rich.text import Text

from judge.judging import Events
from judge.kit.progress import progress_bar
from judge.kit.text import printable_name
from judge.machine import UNCALIBRATED
from judge.problem.verdict import Verdict
from judge.results import CaseResult, GroupResult, Judging

COLOURS = {
    Verdict.AC: "bold green",
    Verdict.WA: "bold red",
    Verdict.CE: "bold yellow",
    Verdict.JE: "bold white on red",
}
OTHER_COLOUR = "bold magenta"


@contextmanager
def live(console: Console) -> Iterator[Events]:
    """Print a line for each case as it ends; on a terminal, also show a bar below the lines."""
    with progress_bar("judging", console=console) as bar:

        def show(result: CaseResult) -> None:
            bar.advance()
            if result.verdict is not None:  # the table counts the cases that were not run
                console.print(case_line(result), soft_wrap=True)

        yield Events(phase=bar.say, start=lambda cases: bar.begin(cases, "judging"), result=show)


def case_line(result: CaseResult) -> Text:
    """Return `AC   0.61 s CPU   0.65 s elapsed    45 MiB  secret/large/03`."""
    line = verdict_text(result.verdict, width=4)
    if result.verdict is None:
        return line.append(f"  {result.case.name}  {result.message}", style="dim")
    line.append(
        f"{result.cpu_s:7.2f} s CPU {result.elapsed_s:7.2f} s elapsed {result.memory_mib:6.0f} MiB"
        f"  {result.case.name}"
    )
    if result.message:
        line.append(f"  {result.message.splitlines()[0]}", style="dim")
    if result.retried:
        first = f", {result.first_verdict} at first" if result.first_verdict else ""
        line.append(f"  (repeated{first})", style="yellow")
    return line


def print_report(console: Console, judging: Judging) -> None:
    """Print the end of a judging: the table of groups, the first failure, limits, verdict."""
    if judging.verdict is Verdict.CE:
        console.print(Text("does not compile:", style=COLOURS[Verdict.CE]))
        console.print(Text(judging.message), soft_wrap=True)
    else:
        console.print(_group_table(judging))
    if failure := judging.first_failure:
        _print_failure(console, failure)
    if judging.changed:
        many = f"{len(judging.changed)} verdicts" if judging.changed[1:] else "1 verdict"
        said = f"{many} changed when the run was repeated under this slower machine's limit"
        console.print(Text(said, style="yellow"), soft_wrap=True)
    console.print(Text(_limits_line(judging), style="dim"), soft_wrap=True)
    if judging.wall is None:
        lost = (
            "there was no wall: the program could read the answers, and read, change and send "
            "whatever you can"
        )
        console.print(Text(lost, style="yellow"), soft_wrap=True)
    else:
        kept = "no network, no files but its own, no processes but its own"
        console.print(Text(f"wall: {judging.wall}: {kept}", style="dim"), soft_wrap=True)
    last = verdict_text(judging.verdict).append(
        f"  {judging.score} of {judging.max_score} points", style="bold"
    )
    if judging.partial:
        last.append("  (partial: not all of the kit's cases)", style="yellow")
    console.print(last.append(f"  {judging.submission} ({judging.language})"), soft_wrap=True)


def verdict_text(verdict: Verdict | None, width: int = 0) -> Text:
    """Return the verdict in its colour; `-` for a case that was not run."""
    if verdict is None:
        return Text("-".ljust(width), style="dim")
    return Text.assemble((verdict.value.ljust(width), COLOURS.get(verdict, OTHER_COLOUR)))


def _group_table(judging: Judging) -> Table:
    table = Table(show_edge=False, pad_edge=False)
    for heading in ("group", "verdict", "points", "cases", "CPU s", "slowest case"):
        numeric = heading in ("points", "cases", "CPU s")
        # On a narrow terminal, the name of a case is the first to be cut.
        least = {"group": 6, "points": 8, "slowest case": None}.get(heading, len(heading))
        justify: JustifyMethod = "right" if numeric else "left"
        table.add_column(heading, justify=justify, no_wrap=True, min_width=least)
    for group in judging.groups:
        slowest = group.slowest
        table.add_row(
            group.name,
            verdict_text(group.verdict),
            f"{group.score} of {group.max_score}" if group.whole else "partial",
            _count(group),
            f"{slowest.cpu_s:.2f}" if slowest else "-",
            slowest.case.name if slowest else "-",
        )
    return table


def _count(group: GroupResult) -> str:
    """Return `47`, or `1 of 47` if not all of the group's chosen cases were run."""
    ran = sum(result.verdict is not None for result in group.cases)
    every = len(group.cases)
    return str(every) if ran == every else f"{ran} of {every}"


def _print_failure(console: Console, failure: CaseResult) -> None:
    headline = Text.assemble("first failure: ", verdict_text(failure.verdict))
    console.print(headline.append(f" on {failure.case.name}: {failure.message}"), soft_wrap=True)
    given, answer = shown(failure.case.input), shown(failure.case.answer)
    lines = f"  input  {given}\n  answer {answer}"
    if failure.mismatch is not None and failure.mismatch.expected is not None:
        number = failure.mismatch.scenario
        lines += f"\n  see it .venv/bin/python -m pictures show {given} {number} > scene.svg"
    console.print(Text(lines), soft_wrap=True)  # a wrapped path could not be copied


def shown(path: Path) -> str:
    """Return a path to type here: relative if it is below the current directory."""
    here = Path.cwd()
    return printable_name(str(path.relative_to(here) if path.is_relative_to(here) else path))


def _limits_line(judging: Judging) -> str:
    limits = f"limits: {judging.time_limit_s:.2f} s of CPU time, {judging.memory_mib} MiB"
    scale = judging.scale
    if scale is not None:
        return (
            f"{limits}; {judging.declared_s:g} s declared, machine scale {scale.factor:.2f} "
            f"({scale.source})"
        )
    if judging.limit_given:
        return f"{limits}; time limit as asked for ({judging.declared_s:g} s declared)"
    if any(result.verdict is Verdict.TLE for result in judging.cases):
        return f"{limits}; {UNCALIBRATED}"
    return limits
