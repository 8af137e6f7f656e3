"""Checking data: each file against the grammar and its group, each case against the manifest."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from gen import manifest
from gen.plan import Case
from gen.validator import InputError, Rules, load_rules, validate


def check_file(path: Path, rules: Rules, name: str = "") -> list[str]:
    """Return what is wrong with an input file, one line each; [] if nothing is."""
    name = name or str(path)
    try:
        with path.open("rb") as stream:
            validate(stream, rules)
    except InputError as fault:
        return [f"{name}:{fault.line}: {fault.reason}"]
    except OSError as error:
        return [f"{name}: cannot be read: {error.strerror}"]
    return []


def check_data(data: Path, cases: Iterable[Case]) -> list[str]:
    """Return what is wrong with a data directory: files, sums, and what nothing plans."""
    entries = manifest.load(data).cases
    faults: list[str] = []
    planned = {case.path: case for case in cases}
    for path, case in planned.items():
        if path not in entries:
            faults.append(f"{path}: planned, but not in the manifest")
            continue
        wrong = manifest.faults(data, path, entries[path])
        if not any(": missing" in fault for fault in wrong):
            rules = load_rules(case.group)
            wrong += check_file(data / f"{path}.in", rules, f"{path}.in")
        faults += wrong
    faults += [
        f"{path}: in the manifest, but not planned" for path in entries if path not in planned
    ]
    for folder in ("sample", "secret"):
        for file in sorted((data / folder).rglob("*")):
            path = file.relative_to(data).with_suffix("").as_posix()
            if file.is_file() and path not in planned:
                faults.append(f"{file.relative_to(data)}: no case of the plan")
    return faults
