"""`python -m strength mutants`: the mutation score of the data."""

from __future__ import annotations

import argparse
import os
import time
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import BrokenExecutor
from pathlib import Path

import msgspec
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn
from rich.table import Table
from rich.text import Text

from judge.kit.files import write_whole
from judge.kit.paths import DATA
from judge.problem.cases import CasesError, check_built, find_cases, group_of
from judge.problem.declaration import SpecError, load
from judge.problem.manifest import check_sums, load_manifest
from strength import equivalents
from strength.campaign import Campaign, CampaignError, Finding, plan_for, programs, run

ERRORS = (CampaignError, CasesError, SpecError, equivalents.EquivalentsError)
HEADINGS = ("program", "mutants", "WA", "RTE", "TLE", "light", "heavy", "equivalent", "survived")


def main(arguments: Sequence[str]) -> int:
    """Run the command; return 0 if every mutant is killed or proved equivalent, else 1; 2 failed.

    Raises ERRORS, OSError, KeyboardInterrupt.
    """
    parser = argparse.ArgumentParser(
        prog="python -m strength mutants",
        description="Change the right programs in small ways, and see that the data notices. "
        "What survives must stand in strength/equivalent.toml, with a proof.",
    )
    parser.add_argument("program", nargs="*", help="by path (default: all right Python programs)")
    parser.add_argument("--quick", type=int, metavar="N", help="only N mutants, chosen by --seed")
    parser.add_argument("--seed", type=int, default=1, help="of --quick (default 1)")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--light", action="store_true", help="only the groups of small files")
    parser.add_argument(
        "--thorough",
        action="store_true",
        help="try on the large files, too, what is called equivalent (takes five times as long)",
    )
    parser.add_argument("--json", type=Path, metavar="FILE", help="write all findings")
    parser.add_argument("--data", type=Path, default=DATA, help="of the test cases")
    options = parser.parse_args(arguments)
    start = time.perf_counter()
    try:
        campaign = _campaign(options)
    except BrokenExecutor as error:
        raise CampaignError(f"a mutant could not be tried: {error}") from None
    _report(campaign, time.perf_counter() - start)
    if options.json:
        write_whole(options.json, _json(campaign), parents=True)
    return 0 if campaign.ok else 1


def _campaign(options: argparse.Namespace) -> Campaign:
    problem = load()
    known = programs(problem)
    for program in options.program:
        if program not in known:
            raise CampaignError(f"{program}: expected one of {', '.join(known)}")
    cases = find_cases(options.data, problem)
    if not options.light:
        check_built(cases, problem.group_names, options.data)
    check_sums(load_manifest(options.data), cases)
    plans = [
        plan_for(program, cases, problem, heavy=not options.light)
        for program in options.program or known
    ]
    console = Console(stderr=True)
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn())
    with Progress(*columns, console=console, transient=True) as progress:
        task = progress.add_task("the programs as they are", total=None)

        def begin(count: int) -> None:
            progress.update(task, description="mutants", total=count)

        def advance(_finding: Finding) -> None:
            progress.advance(task)

        return run(
            plans,
            equivalents.load(),
            problem,
            jobs=options.jobs,
            quick=options.quick,
            seed=options.seed,
            thorough=options.thorough,
            start=begin,
            done=advance,
        )


def _report(campaign: Campaign, seconds: float) -> None:
    """Print the table of programs, then every finding that is not as it should be."""
    console = Console()
    table = Table(show_edge=False, pad_edge=False)
    for heading in HEADINGS:
        table.add_column(heading, justify="left" if heading == "program" else "right")
    by_program: dict[str, list[Finding]] = {}
    for finding in campaign.findings:
        by_program.setdefault(finding.mutant.program, []).append(finding)
    for program, findings in [*by_program.items(), ("all", list(campaign.findings))]:
        table.add_row(program, *map(str, _figures(findings)))
    console.print(table)
    killed_of = [f for f in campaign.findings if f.entry is None or f.kill]
    killed = sum(f.kill is not None for f in killed_of)
    console.print(
        f"mutation score: {killed} of {len(killed_of)} that are not equivalent; {seconds:.0f} s"
    )
    for finding in campaign.findings:
        if finding.survived:
            console.print(Text(f"survived: {finding.mutant}"), soft_wrap=True)
        if finding.stale and finding.kill:
            why = f"{finding.kill.verdict} on {finding.kill.case}"
            text = f"called equivalent, but killed ({why}): {finding.mutant}"
            console.print(Text(text), soft_wrap=True)
    for line in campaign.unused:
        text = f"called equivalent, but no such mutant any more: {line}"
        console.print(Text(text), soft_wrap=True)


def _figures(findings: Sequence[Finding]) -> tuple[int, ...]:
    """Return the figures of one row, in the order of HEADINGS."""
    kills = [finding.kill for finding in findings if finding.kill]
    verdicts = Counter(kill.verdict.value for kill in kills)
    light = sum(group_of(kill.case) in ("sample", "static", "small") for kill in kills)
    equivalent = sum(f.entry is not None and f.kill is None for f in findings)
    survived = sum(f.survived for f in findings)
    return (
        len(findings),
        verdicts["WA"],
        verdicts["RTE"] + verdicts["CE"],
        verdicts["TLE"],
        light,
        len(kills) - light,
        equivalent,
        survived,
    )


def _json(campaign: Campaign) -> bytes:
    rows = [
        {
            "program": f.mutant.program,
            "function": f.mutant.function,
            "line_number": f.mutant.number,
            "line": f.mutant.line,
            "mutated": f.mutant.mutated,
            "nth": f.mutant.nth,
            "verdict": f.kill.verdict.value if f.kill else None,
            "case": f.kill.case if f.kill else None,
            "equivalent": f.entry.proof if f.entry and not f.kill else None,
        }
        for f in campaign.findings
    ]
    content = {"version": 1, "mutants": rows, "unused": list(campaign.unused)}
    return msgspec.json.format(msgspec.json.encode(content), indent=1) + b"\n"
