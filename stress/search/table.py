"""`python -m stress table`: the smallest counterexample of every wrong submission, as a table."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median

from gen.scenario import parse
from judge.explanation import Counterexample
from judge.judging import Events, Options, judge
from judge.kit.command import Parser, add_jobs, whole_number
from judge.kit.files import check_place, write_report
from judge.kit.paths import ROOT, SUBMISSIONS
from judge.kit.processors import cores
from judge.kit.progress import progress_bar
from judge.languages.submission import read_submission
from judge.problem.declaration import Problem, load
from judge.problem.verdict import Verdict
from judge.results import Judging
from stress.front import make_search
from stress.shrinking.measure import numbers_of

TABLE = ROOT / "docs" / "counterexamples.md"
FOLDERS = ("wrong_answer", "run_time_error")
VERTICES = {0: 8, 1: 8, 2: 9}  # by obstacles, of a small counterexample; 9: three triangles
COORDINATE = 20  # its numbers are below
HEAD = """\
# Smallest counterexamples

What `./checker.py SUBMISSION --explain --seed {seed}` finds for each wrong or crashing submission
of the kit: the size of the scenario that is answered wrongly (of the last one, where several are
needed), its largest number, the seconds from the verdict to the counterexample, the input on one
line. Written by `python -m stress table`; the seconds are those of one machine.

{summary}

| submission | what it does wrong | scenarios | obstacles | vertices | largest | seconds | input |
| --- | --- | --- | --- | --- | --- | --- | --- |
"""
LONGEST_INPUT = 160  # characters; of larger ones, only the size is shown


@dataclass(frozen=True, slots=True)
class Row:
    """A submission with its counterexample, None if none was found, and why."""

    submission: str
    bug: str
    found: Counterexample | None
    why: str = ""

    @property
    def largest(self) -> int:
        """The largest |number| of the last scenario."""
        if self.found is None:
            return 0
        return max(map(abs, numbers_of(parse(self.found.input.encode())[-1])))

    @property
    def has_few_vertices(self) -> bool:
        """Whether there is one, with few obstacles and vertices."""
        found = self.found
        return found is not None and found.vertices <= VERTICES.get(found.obstacles, 0)


def command(arguments: Sequence[str]) -> int:
    """Judge all wrong submissions, search, and write the table. Returns 0. Raises KitError."""
    parser = Parser(prog="python -m stress table", description=__doc__)
    add = parser.add_argument
    add("submission", nargs="*", help="path below submissions/ (default: all that are wrong)")
    add("--seed", type=whole_number(0), default=1, metavar="N", help="of the search (default 1)")
    add("--output", type=Path, default=TABLE, metavar="FILE", help="where to write the table")
    add_jobs(parser, cores(), "runs")
    asked = parser.parse_args(arguments)
    check_place("--output", asked.output)
    problem = load()
    names = asked.submission or wrong_submissions(problem)
    rows = []
    with progress_bar("searching", len(names)) as bar:
        for row in rows_of(names, problem, asked.seed, asked.jobs):
            rows.append(row)
            bar.say(row.submission)
            bar.advance()
    write_report("--output", asked.output, lambda: as_markdown(rows, asked.seed).encode())
    print(summary(rows))
    return 0


def wrong_submissions(problem: Problem) -> list[str]:
    """Return the submissions that answer wrongly or crash, by their paths in submissions/."""
    return [name for name in problem.submissions if name.partition("/")[0] in FOLDERS]


def rows_of(names: Sequence[str], problem: Problem, seed: int, jobs: int) -> Iterator[Row]:
    """Yield the row of each submission, as soon as it is known. Raises KitError."""
    for name in names:
        path = SUBMISSIONS / name
        judging = _judged(path, problem, seed, jobs)
        yield Row(name, _first_line(path), judging.counterexample, judging.unexplained)


def _judged(path: Path, problem: Problem, seed: int, jobs: int) -> Judging:
    """Judge a submission until a group fails, then search. Groups that it passes are left out."""
    name = path.relative_to(SUBMISSIONS).as_posix()
    judging: Judging | None = None
    for group in problem.group_names:
        if problem.expected(name, group) == {Verdict.AC}:
            continue
        options = Options(groups=(group,), jobs=jobs, stop_on_first=True)
        search = make_search(seed, add=False)
        judging = judge(read_submission(path), problem, options, events=Events(), search=search)
        if judging.verdict is not Verdict.AC:
            break
    assert judging is not None
    return judging


def _first_line(path: Path) -> str:
    """Return what a submission says about itself in its first line."""
    lines = path.read_text(encoding="utf-8").splitlines()
    line = next(line for line in lines if not line.startswith("#!"))
    return line.strip('"/ ').rstrip(".")


def summary(rows: Sequence[Row]) -> str:
    """Return how many are small, and the median seconds by language."""
    few = [row for row in rows if row.has_few_vertices]
    small = sum(row.largest < COORDINATE for row in few)
    text = (
        f"Of {len(rows)} submissions, {len(few)} have a counterexample with at most {VERTICES[1]} "
        f"vertices ({VERTICES[2]} if it needs two obstacles); in {small} of these, all numbers are "
        f"below {COORDINATE}. For the others, nothing smaller was found."
    )
    for language, suffix in (("C++", ".cpp"), ("Python", ".py")):
        seconds = [
            row.found.seconds for row in rows if row.found and row.submission.endswith(suffix)
        ]
        if seconds:
            text += f" Median for {language}: {median(seconds):.1f} s."
    return text


def as_markdown(rows: Sequence[Row], seed: int) -> str:
    """Return the table as a document."""
    head = HEAD.format(seed=seed, summary=summary(rows))
    return head + "".join(f"| {' | '.join(_cells(row))} |\n" for row in rows)


def _cells(row: Row) -> list[str]:
    bug = row.bug.replace("|", "\\|")
    found = row.found
    if found is None:
        return [f"`{row.submission}`", bug, "", "", "", "", "", row.why]
    text = found.input.strip().replace("\n", " / ")
    shown = f"`{text}`" if len(text) <= LONGEST_INPUT else ""
    figures = (found.scenarios, found.obstacles, found.vertices, row.largest)
    return [f"`{row.submission}`", bug, *map(str, figures), f"{found.seconds:.1f}", shown]
