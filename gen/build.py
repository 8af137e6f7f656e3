"""The build: from recipes to inputs, answers and manifest entries."""

from __future__ import annotations

import gc
import io
import multiprocessing
import signal
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from gen.answers import DisagreementError, agreed, answer_file, recorded_answers
from gen.families import FamilyError, find
from gen.plan import HAND_MADE, Recipe
from gen.rng import derive
from gen.scenario import Scenario, parse, render
from gen.validator import InputError, load_rules, validate
from judge.kit.checksums import Checksums
from judge.kit.errors import KitError
from judge.kit.files import write_whole
from judge.kit.paths import BUILD, REFERENCE, ROOT
from judge.kit.trusted import ProgramError
from judge.problem.manifest import Entry, file_faults, sum_of

DISAGREEMENTS = BUILD / "disagreements"


class BuildError(KitError):
    """A case cannot be built, or is not what the manifest says."""


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


def build_case(data: Path, recipe: Recipe, expected: Entry | None, *, verify: bool) -> Entry:
    """Make both files of a case and return its entry.

    expected: what the manifest says of it; None: anything. Nothing is written unless the
    files are as expected, or else the input is valid and two methods agree on the answers.
    verify: have the input validated and the answers confirmed even if they are as expected.
    Raises BuildError.
    """
    try:
        content, scenarios = _input(data, recipe)
        answers = None
        if expected is not None and not verify and sum_of(content) == expected.input:
            answers = _expected_answers(data / f"{recipe.case_name}.ans", content, expected)
        if expected is None or answers is None or changes(recipe, expected):
            entry, answers = _verified(recipe, content, scenarios)
            _compare(recipe, entry, expected)
        else:
            entry = expected
    except InputError as fault:
        raise BuildError(f"{recipe.case_name}.in:{fault.line}: {fault.reason}") from None
    except (FamilyError, ProgramError) as error:
        raise BuildError(f"{recipe.case_name}: {error}") from None
    if recipe.family != HAND_MADE:
        write_whole(data / f"{recipe.case_name}.in", content, parents=True)
    write_whole(data / f"{recipe.case_name}.ans", answers, parents=True)
    return entry


def _input(data: Path, recipe: Recipe) -> tuple[bytes, Sequence[Scenario]]:
    """Return the input of a case, made or read, and its scenarios."""
    if recipe.family != HAND_MADE:
        scenarios = find(recipe.family).scenarios(recipe.parameters, recipe.repeat)
        return render(scenarios), scenarios
    path = data / f"{recipe.case_name}.in"
    try:
        content = path.read_bytes()
    except OSError as error:
        raise BuildError(f"{path}: the hand-made input cannot be read: {error.strerror}") from None
    validate(io.BytesIO(content), load_rules(recipe.group))
    return content, parse(content)


def _expected_answers(file: Path, content: bytes, expected: Entry) -> bytes | None:
    """Return the answers if they have the expected checksum, None if not.

    Those that are there already need no reference, which a kit for students does not hold.
    """
    if file.is_file() and sum_of(there := file.read_bytes()) == expected.answer:
        return there
    answers = recorded_answers(expected)
    if answers is None:
        answers = answer_file(REFERENCE, content, expected.scenarios)
    return answers if sum_of(answers) == expected.answer else None


def _verified(recipe: Recipe, content: bytes, scenarios: Sequence[Scenario]) -> tuple[Entry, bytes]:
    """Return the entry and the answers of a valid input on which two methods agree."""
    summary = validate(io.BytesIO(content), load_rules(recipe.group))
    try:
        answers = agreed(content, scenarios)
    except DisagreementError as error:
        kept = DISAGREEMENTS / f"{recipe.case_name.replace('/', '-')}.in"
        write_whole(kept, content, parents=True)
        raise BuildError(
            f"{recipe.case_name}: {error}; the input is kept in {kept.relative_to(ROOT)}"
        ) from None
    entry = Entry(
        **_making(recipe),
        input=sum_of(content),
        answer=sum_of(answers),
        scenarios=summary.scenarios,
        vertices=summary.vertices,
        pair_sum=summary.pair_sum,
        yes=answers.count(b"YES"),
        no=answers.count(b"NO"),
    )
    return entry, answers


def _compare(recipe: Recipe, entry: Entry, expected: Entry | None) -> None:
    """Raise BuildError unless an entry is as expected."""
    if expected is None or entry == expected:
        return
    fields = Entry.__struct_fields__
    differing = [name for name in fields if getattr(entry, name) != getattr(expected, name)]
    raise BuildError(
        f"{recipe.case_name}: differs from the manifest in {', '.join(differing)}; "
        "if that is meant, build with --update-manifest"
    )


def _making(recipe: Recipe) -> dict[str, Any]:
    """Return what the manifest says of how a case is made, by field. Raises FamilyError."""
    parameters = recipe.resolved()
    return {
        "family": recipe.family,
        "parameters": parameters,
        "repeat": recipe.repeat,
        "seed": 0
        if recipe.family == HAND_MADE
        else derive(recipe.family, parameters, recipe.repeat),
    }


def changes(recipe: Recipe, entry: Entry) -> list[str]:
    """Return in which fields the entry of a case differs from what its recipe says."""
    return [field for field, value in _making(recipe).items() if getattr(entry, field) != value]


def is_current(data: Path, recipe: Recipe, entry: Entry | None, checksums: Checksums) -> bool:
    """Tell whether both files are there as the manifest says, made as the recipe says."""
    if entry is None or changes(recipe, entry):
        return False
    return not file_faults(data, recipe.case_name, entry, checksums)


def build_cases(
    data: Path,
    recipes: Iterable[Recipe],
    expected: Mapping[str, Entry],
    *,
    update: bool,
    verify: bool,
    jobs: int,
    done: Callable[[Recipe], None],
) -> dict[str, Entry]:
    """Build cases in `jobs` processes and return their entries; the first fault ends it.

    expected: the manifest's entries; a case must come out as its entry says, and must have
    one, unless `update`. verify: see `build_case`. done: called for every finished case, in
    the caller's process. Raises BuildError.
    """
    recipes = list(recipes)
    for recipe in recipes:
        if not update and recipe.case_name not in expected:
            raise BuildError(
                f"{recipe.case_name}: not in the manifest; build with --update-manifest"
            )
    entries: dict[str, Entry] = {}
    with workers(jobs) as pool:
        pending: dict[Future[Entry], Recipe] = {}
        for recipe in sorted(recipes, key=lambda recipe: _cost(recipe, expected), reverse=True):
            entry = None if update else expected[recipe.case_name]
            pending[pool.submit(build_case, data, recipe, entry, verify=verify)] = recipe
        while pending:
            finished, _ = wait(pending, return_when=FIRST_COMPLETED)
            for future in finished:
                recipe = pending.pop(future)
                entries[recipe.case_name] = future.result()
                done(recipe)
    return entries


@contextmanager
def workers(jobs: int) -> Iterator[ProcessPoolExecutor]:
    """Give `jobs` processes to a block; if it fails or is interrupted, they end at once."""
    pool = ProcessPoolExecutor(max_workers=jobs, initializer=_begin_worker)
    try:
        yield pool
    except BaseException:
        # The workers clean up after themselves: see _begin_worker.
        for worker in multiprocessing.active_children():
            worker.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def _cost(recipe: Recipe, expected: Mapping[str, Entry]) -> int:
    """Return about how long a case takes to build: the longest begin, so that all end together."""
    entry = expected.get(recipe.case_name)
    return entry.vertices + 20 * entry.scenarios if entry is not None else 0


def _begin_worker() -> None:
    """Let the parent alone see Ctrl-C; SIGTERM unwinds what a worker is doing, then ends it.

    Scenes hold no reference cycles, so looking for garbage among millions of vertices is in vain.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    gc.disable()
