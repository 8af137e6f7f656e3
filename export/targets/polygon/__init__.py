"""Codeforces Polygon: a "full package", with problem.xml, validator and checker for testlib."""

from __future__ import annotations

from export.files import Files
from export.formats.layout import runnable
from export.package import Package
from export.target import Target
from export.targets.polygon import descriptor as names
from export.targets.polygon import generator
from export.targets.polygon.programs import CHECKER_TESTS, checker, validator
from export.targets.polygon.statement import statement


def build(package: Package) -> Files:
    """Lay out the package; problem.xml names every file but the statement's parts."""
    files = Files()
    files.add("problem.xml", names.descriptor(package))
    files.merge(statement(package))
    cases = [case for group in package.groups for case in group.cases]
    for number, case in enumerate(cases, 1):
        files.add(names.TEST % number, case.input)
        files.add(names.TEST % number + names.ANSWER, case.answer)
    for path in (names.CHECKER, names.CHECKER_COPY):
        files.add(path, checker())
    files.add(names.VALIDATOR, validator(package.problem))
    files.add(names.GENERATOR, generator.source(package, generator.recipes(package)))
    for submission in runnable(package):
        files.add(names.SOLUTION.format(submission.file), submission.path)
    files.merge(program_tests(package))
    return files


def program_tests(package: Package) -> Files:
    """Return the tests of the checker, and of the validator: samples, then invalid files."""
    files = Files()
    for number, test in enumerate(CHECKER_TESTS, 1):
        stem = names.CHECKER_TEST % number
        files.add(stem, package.samples[0].input)
        files.add(stem + names.OUTPUT, test.output)
        files.add(stem + names.ANSWER, test.answer)
    inputs = [case.input for case in package.samples]
    inputs += [fault.path for fault in package.invalid_inputs]
    for number, path in enumerate(inputs, 1):
        files.add(names.VALIDATOR_TEST % number, path)
    return files


TARGETS = (
    Target(
        name="polygon",
        title="Codeforces Polygon, and all that reads its packages",
        build=build,
        import_it="Unpack it, then: polygon-cli init PROBLEM; polygon-cli import_package DIRECTORY",
        compact=True,
    ),
)
