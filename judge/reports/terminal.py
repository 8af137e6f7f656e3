"""What a person sees of a judging: live progress, the end table, the first failure."""

from __future__ import annotations

import re
from pathlib import Path
from types import TracebackType
from typing import Self

from rich.console import Console, JustifyMethod
from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TextColumn
from rich.table import Table
from rich.text import Text

from judge.judging import Events
from judge.kit.text import printable_name
from judge.problem.verdict import Verdict
from judge.results import CaseResult, Judging

COLOURS = {
    Verdict.AC: "bold green",
    Verdict.WA: "bold red",
    Verdict.CE: "bold yellow",
    Verdict.JE: "bold white on red",
}
OTHER_COLOUR = "bold magenta"


class Live:
    """A line per finished case, and on a terminal a bar below them while the judging goes on."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._progress = Progress(
            SpinnerColumn(),
            TextColumn("{task.description}"),
            BarColumn(),
            MofNCompleteColumn(),
            console=console,
            transient=True,
            disable=not console.is_terminal,
        )
        self._task = self._progress.add_task("judging", total=None)
        self.events = Events(phase=self._phase, start=self._start, result=self._result)

    def __enter__(self) -> Self:
        self._progress.start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._progress.stop()

    def _phase(self, text: str) -> None:
        self._progress.update(self._task, description=text)

    def _start(self, cases: int) -> None:
        self._progress.update(self._task, description="judging", total=cases)

    def _result(self, result: CaseResult) -> None:
        self._progress.advance(self._task)
        if result.verdict is None:  # not run: the table's end is soon enough to see that
            return
        self._progress.console.print(case_line(result), soft_wrap=True)


def case_line(result: CaseResult) -> Text:
    """Return `AC   0.61 s CPU   0.65 s wall    45 MiB  secret/large/03`."""
    line = verdict_text(result.verdict, width=4)
    if result.verdict is None:
        return line.append(f"  {result.case.name}  {result.message}", style="dim")
    line.append(
        f"{result.cpu_s:7.2f} s CPU {result.wall_s:7.2f} s wall {result.memory_mib:6.0f} MiB  "
        f"{result.case.name}"
    )
    if result.message:
        line.append(f"  {result.message.splitlines()[0]}", style="dim")
    if result.retried:
        first = f", {result.first_verdict} at first" if result.first_verdict else ""
        line.append(f"  (run again alone{first})", style="yellow")
    return line


def print_report(console: Console, judging: Judging) -> None:
    """Print the end of a judging: the first failure, the table of groups, limits, verdict."""
    if judging.verdict is Verdict.CE:
        console.print(Text("does not compile:", style=COLOURS[Verdict.CE]))
        console.print(Text(judging.message), soft_wrap=True)
    else:
        console.print(_group_table(judging))
    if failure := judging.first_failure:
        _print_failure(console, failure)
    if judging.changed:
        many = f"{len(judging.changed)} verdicts" if judging.changed[1:] else "1 verdict"
        said = f"{many} changed between two runs; the run alone decided: this machine is noisy"
        console.print(Text(said, style="yellow"), soft_wrap=True)
    console.print(Text(_limits_line(judging), style="dim"), soft_wrap=True)
    if judging.wall is None:
        lost = (
            "no wall stood: the program could read the answers, and read, change and send "
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
            str(len(group.cases)),
            f"{slowest.cpu_s:.2f}" if slowest else "-",
            slowest.case.name if slowest else "-",
        )
    return table


def _print_failure(console: Console, failure: CaseResult) -> None:
    headline = Text.assemble("first failure: ", verdict_text(failure.verdict))
    console.print(headline.append(f" on {failure.case.name}: {failure.message}"), soft_wrap=True)
    given, answer = shown(failure.case.input), shown(failure.case.answer)
    lines = f"  input  {given}\n  answer {answer}"
    if scenario := re.match(r"scenario (\d+):", failure.message):
        lines += f"\n  see it .venv/bin/python -m pictures show {given} {scenario[1]} > scene.svg"
    console.print(Text(lines), soft_wrap=True)  # a path broken in two cannot be copied


def shown(path: Path) -> str:
    """Return a path as one would type it here: relative if it lies below this directory."""
    here = Path.cwd()
    return printable_name(str(path.relative_to(here) if path.is_relative_to(here) else path))


def _limits_line(judging: Judging) -> str:
    limits = f"limits: {judging.time_limit_s:.2f} s of CPU time, {judging.memory_mib} MiB"
    if judging.scale is not None:
        return (
            f"{limits}; {judging.declared_s:g} s declared, machine scale {judging.scale:.2f} "
            "by the reference's time"
        )
    if judging.time_limit_s != judging.declared_s:
        return f"{limits}; time limit as asked for ({judging.declared_s:g} s declared)"
    return f"{limits}; not scaled to this machine: the calibration case is not built"
