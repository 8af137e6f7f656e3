"""The report on the terminal: live progress, the table of groups, the first failure."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from rich.console import Console, JustifyMethod
from rich.table import Table
from rich.text import Text

from judge.feedback import Teller
from judge.judging import Events
from judge.kit.progress import progress_bar
from judge.problem.declaration import Feedback
from judge.problem.verdict import Verdict
from judge.reports.explained import print_explained
from judge.reports.words import changed_line, count_of, limits_line, wall_line
from judge.results import CaseResult, Judging

COLOURS = {
    Verdict.AC: "bold green",
    Verdict.WA: "bold red",
    Verdict.CE: "bold yellow",
    Verdict.JE: "bold white on red",
}
OTHER_COLOUR = "bold magenta"


@contextmanager
def live(console: Console, feedback: Feedback) -> Iterator[Events]:
    """Print a line for each case as it ends; on a terminal, also show a bar below the lines.

    feedback: what may be told of a case.
    """
    teller = Teller(feedback)
    with progress_bar("judging", console=console) as bar:

        def show(result: CaseResult) -> None:
            bar.advance()
            told = teller.result(result)
            if told.verdict is not None:  # the table counts the cases that were not run
                console.print(case_line(told), soft_wrap=True)

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


def print_report(
    console: Console,
    judging: Judging,
    *,
    explain: bool = False,
    verbose: bool = False,
    hint: str = "",
) -> None:
    """Print the end of a judging: the table of groups, why it failed, limits, verdict.

    explain: all missed lessons. verbose: all that is kept of standard error. hint: what else
    can be asked about a failure.
    """
    if judging.verdict is Verdict.CE:
        console.print(Text("does not compile:", style=COLOURS[Verdict.CE]))
        console.print(Text(judging.message), soft_wrap=True)
    else:
        console.print(_group_table(judging))
    if failure := judging.first_failure:
        verdict = verdict_text(failure.verdict)
        print_explained(console, judging, verdict, explain=explain, verbose=verbose)
        if hint:
            console.print(Text(hint, style="dim"), soft_wrap=True)
    if changed := changed_line(judging):
        console.print(Text(changed, style="yellow"), soft_wrap=True)
    console.print(Text(f"limits: {limits_line(judging)}", style="dim"), soft_wrap=True)
    if judging.wall is None:
        console.print(Text(wall_line(judging), style="yellow"), soft_wrap=True)
    else:
        console.print(Text(f"wall: {wall_line(judging)}", style="dim"), soft_wrap=True)
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
            count_of(group),
            f"{slowest.cpu_s:.2f}" if slowest else "-",
            slowest.case.name if slowest else "-",
        )
    return table
