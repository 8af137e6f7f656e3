"""`python -m strength mutants`: the mutation score of the data."""

from __future__ import annotations

import argparse
import time
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import msgspec
from rich.console import Console
from rich.table import Table
from rich.text import Text

from judge.kit.command import Parser, add_jobs, whole_number
from judge.kit.console import PlainConsole
from judge.kit.files import check_place, write_report
from judge.kit.paths import DATA
from judge.kit.processors import processors
from judge.kit.progress import progress_bar
from judge.kit.store import Store
from judge.problem.cases import group_of
from judge.problem.data import load_data
from judge.problem.declaration import Problem, load
from strength.mutants import equivalents
from strength.mutants.campaign import (
    Campaign,
    CampaignError,
    Finding,
    light_groups,
    plan_for,
    programs,
    run,
)

ALL_KILLED, SURVIVORS = 0, 1
HEADINGS = ("program", "mutants", "WA", "RTE", "TLE", "light", "heavy", "equivalent", "survived")


def command(arguments: Sequence[str]) -> int:
    """Return 0 if every mutant is killed or proved equivalent, else 1. Raises KitError, OSError."""
    parser = Parser(
        prog="python -m strength mutants",
        description="Change the right programs in small ways, and see that the data notices. "
        "A mutant that survives must be listed in strength/equivalent.toml, with a proof.",
    )
    add = parser.add_argument
    add("program", nargs="*", help="by path (default: all right Python programs)")
    add("--quick", type=whole_number(1), metavar="N", help="only N mutants, chosen by --seed")
    add("--seed", type=int, default=1, help="of --quick (default 1)")
    add_jobs(parser, processors(), "mutants tried")
    add("--light", action="store_true", help="only the groups of small files")
    add(
        "--thorough",
        action="store_true",
        help="try mutants listed as equivalent on the large files too (takes five times as long)",
    )
    add("--json", type=Path, metavar="FILE", help="write all findings")
    add("--data", type=Path, default=DATA, help="of the test cases")
    options = parser.parse_args(arguments)
    check_place("--json", options.json)
    start = time.perf_counter()
    problem = load()
    campaign = _campaign(options, problem)
    _print(campaign, problem, time.perf_counter() - start)
    write_report("--json", options.json, lambda: _json(campaign))
    return ALL_KILLED if campaign.ok else SURVIVORS


def _campaign(options: argparse.Namespace, problem: Problem) -> Campaign:
    known = programs(problem)
    for program in options.program:
        if program not in known:
            raise CampaignError(f"{program}: expected one of {', '.join(known)}")
    directory = options.data.resolve()
    groups = light_groups(problem) if options.light and directory == DATA else ()
    with Store() as store:
        cases = load_data(problem, directory, groups, store=store).chosen
    plans = [
        plan_for(program, cases, problem, heavy=not options.light)
        for program in options.program or known
    ]
    with progress_bar("the unchanged programs") as bar:
        return run(
            plans,
            equivalents.load(),
            problem,
            jobs=options.jobs,
            quick=options.quick,
            seed=options.seed,
            thorough=options.thorough,
            start=lambda mutants: bar.begin(mutants, "mutants"),
            done=lambda _finding: bar.advance(),
        )


def _print(campaign: Campaign, problem: Problem, seconds: float) -> None:
    """Print the table of programs, then every finding that is not as it should be."""
    console = PlainConsole()
    console.print(_table(campaign, light_groups(problem)))
    considered = [f for f in campaign.findings if f.equivalent is None or f.kill]
    killed = sum(f.kill is not None for f in considered)
    score = f"{killed} of {len(considered)} mutants that are not equivalent"
    console.print(f"mutation score: {score}; {seconds:.0f} s")
    for finding in campaign.findings:
        if finding.survived:
            _line(console, f"survived: {finding.mutant}")
        if finding.stale and finding.kill:
            why = f"{finding.kill.verdict} on {finding.kill.case}"
            _line(console, f"listed as equivalent, but killed ({why}): {finding.mutant}")
    for change in campaign.unused:
        _line(console, f"listed as equivalent, but no mutant any more: {change}")


def _line(console: Console, text: str) -> None:
    console.print(Text(text), soft_wrap=True)


def _table(campaign: Campaign, light: Sequence[str]) -> Table:
    """Return a row of figures for each program, and one for all."""
    table = Table(show_edge=False, pad_edge=False)
    for heading in HEADINGS:
        table.add_column(heading, justify="left" if heading == "program" else "right")
    by_program: dict[str, list[Finding]] = {}
    for finding in campaign.findings:
        by_program.setdefault(finding.mutant.program, []).append(finding)
    for program, findings in [*by_program.items(), ("all", list(campaign.findings))]:
        table.add_row(program, *map(str, _figures(findings, light)))
    return table


def _figures(findings: Sequence[Finding], light: Sequence[str]) -> tuple[int, ...]:
    """Return the figures of one row, in the order of HEADINGS."""
    kills = [finding.kill for finding in findings if finding.kill]
    verdicts = Counter(kill.verdict.value for kill in kills)
    by_light = sum(group_of(kill.case) in light for kill in kills)
    return (
        len(findings),
        verdicts["WA"],
        verdicts["RTE"] + verdicts["CE"],
        verdicts["TLE"],
        by_light,
        len(kills) - by_light,
        sum(f.equivalent is not None and f.kill is None for f in findings),
        sum(f.survived for f in findings),
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
            "equivalent": f.equivalent.proof if f.equivalent and not f.kill else None,
        }
        for f in campaign.findings
    ]
    content = {"version": 1, "mutants": rows, "unused": list(campaign.unused)}
    return msgspec.json.format(msgspec.json.encode(content), indent=1) + b"\n"
