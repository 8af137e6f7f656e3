"""A plain zip: the test cases as pairs of files, as online-judge-tools and most scripts read it."""

from __future__ import annotations

from export.files import Files
from export.package import Package
from export.target import Target


def build(package: Package) -> Files:
    """Lay out `test/GROUP-CASE.in` and `.out`."""
    files = Files()
    for group in package.groups:
        for case in group.cases:
            stem = f"test/{group.name}-{case.input.stem}"
            files.add(f"{stem}.in", case.input)
            files.add(f"{stem}.out", case.answer)
    return files


TARGETS = (
    Target(
        name="plain",
        title="pairs of files, for scripts and online-judge-tools",
        build=build,
        import_it="Unpack it and run: oj test --directory test --command 'python3 solution.py'",
    ),
)
