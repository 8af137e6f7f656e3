"""The build: plan, family, input, validator, answers, agreement, manifest."""

from __future__ import annotations

import io
import multiprocessing
import signal
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from pathlib import Path

from gen import manifest
from gen.answers import AnswerError, DisagreementError, agreed
from gen.families import FamilyError, find
from gen.manifest import Entry
from gen.plan import HAND_MADE, Case
from gen.rng import derive
from gen.scenario import Scenario, parse, render
from gen.validator import InputError, load_rules, validate
from judge.kit.errors import KitError
from judge.kit.files import write_whole
from judge.kit.paths import ROOT

DISAGREEMENTS = ROOT / "build" / "disagreements"


class BuildError(KitError):
    """A case cannot be built, or is not what the manifest says; one clear line."""


def render_family(family: str, parameters: Mapping[str, int | str], repeat: int) -> bytes:
    """Return a valid input file of a family; FamilyError when the parameters permit none."""
    content = render(find(family).scenarios(parameters, repeat))
    try:
        validate(io.BytesIO(content), load_rules())
    except InputError as fault:
        raise FamilyError(
            f"family {family}: these parameters make no valid file: "
            f"line {fault.line}: {fault.reason}"
        ) from None
    return content


def build_case(data: Path, case: Case, expected: Entry | None) -> Entry:
    """Make both files of a case and return its entry.

    expected: what the manifest says of it; None: anything. Nothing is written unless the
    input is valid, two methods agree and the sums are as expected. Raises BuildError.
    """
    try:
        content, scenarios, parameters = _input(data, case)
        summary = validate(io.BytesIO(content), load_rules(case.group))
    except InputError as fault:
        raise BuildError(f"{case.path}.in:{fault.line}: {fault.reason}") from None
    except FamilyError as error:
        raise BuildError(f"{case.path}: {error}") from None
    try:
        answers = agreed(content, scenarios)
    except DisagreementError as error:
        kept = DISAGREEMENTS / f"{case.path.replace('/', '-')}.in"
        write_whole(kept, content, parents=True)
        raise BuildError(
            f"{case.path}: {error}; the input is kept in {kept.relative_to(ROOT)}"
        ) from None
    except AnswerError as error:
        raise BuildError(f"{case.path}: {error}") from None
    entry = Entry(
        family=case.family,
        parameters=dict(sorted(parameters.items())),
        repeat=case.repeat,
        seed=derive(case.family, parameters, case.repeat) if case.family else 0,
        input=manifest.sum_of(content),
        answer=manifest.sum_of(answers),
        scenarios=summary.scenarios,
        vertices=summary.vertices,
        pair_sum=summary.pair_sum,
        yes=answers.count(b"YES"),
        no=answers.count(b"NO"),
    )
    if expected is not None and entry != expected:
        differing = [
            name
            for name in Entry.__struct_fields__
            if getattr(entry, name) != getattr(expected, name)
        ]
        raise BuildError(
            f"{case.path}: differs from the manifest in {', '.join(differing)}; "
            "if that is meant, build with --update-manifest"
        )
    if case.family != HAND_MADE:
        write_whole(data / f"{case.path}.in", content, parents=True)
    write_whole(data / f"{case.path}.ans", answers, parents=True)
    return entry


def _input(data: Path, case: Case) -> tuple[bytes, Sequence[Scenario], Mapping[str, int | str]]:
    if case.family == HAND_MADE:
        try:
            content = (data / f"{case.path}.in").read_bytes()
        except OSError as error:
            raise FamilyError(f"the hand-made input cannot be read: {error.strerror}") from None
        validate(io.BytesIO(content), load_rules(case.group))
        return content, parse(content), {}
    family = find(case.family)
    parameters = family.resolve(case.parameters)
    scenarios = family.scenarios(parameters, case.repeat)
    return render(scenarios), scenarios, parameters


def is_current(data: Path, case: Case, entry: Entry | None) -> bool:
    """Tell whether both files are there as the manifest says, made as the plan says."""
    if entry is None or (entry.family, entry.repeat) != (case.family, case.repeat):
        return False
    if case.family != HAND_MADE:
        try:
            parameters = find(case.family).resolve(case.parameters)
        except FamilyError:
            return False
        if parameters != entry.parameters:
            return False
    return not manifest.faults(data, case.path, entry)


def build_cases(
    data: Path,
    cases: Iterable[Case],
    expected: Mapping[str, Entry],
    *,
    update: bool,
    jobs: int,
    done: Callable[[Case], None],
) -> dict[str, Entry]:
    """Build the cases in `jobs` processes and return their entries; the first fault ends it.

    expected: the manifest's entries; a case must come out as its entry says, and must have
    one, unless `update`. `done` is called for every finished case, in the caller's process.
    Raises BuildError.
    """
    entries: dict[str, Entry] = {}
    cases = list(cases)
    if not update:
        for case in cases:
            if case.path not in expected:
                raise BuildError(f"{case.path}: not in the manifest; build with --update-manifest")
    pool = ProcessPoolExecutor(max_workers=jobs, initializer=_end_on_sigterm)
    try:
        pending: dict[Future[Entry], Case] = {
            pool.submit(build_case, data, case, None if update else expected[case.path]): case
            for case in cases
        }
        while pending:
            finished, _ = wait(pending, return_when=FIRST_COMPLETED)
            for future in finished:
                case = pending.pop(future)
                entries[case.path] = future.result()
                done(case)
    except BaseException:
        # The workers clean up after themselves: see _end_on_sigterm.
        for worker in multiprocessing.active_children():
            worker.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)
    return entries


def _end_on_sigterm() -> None:
    """Let the parent alone see Ctrl-C; SIGTERM unwinds what a worker is doing, then ends it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
