"""What a target is: one judge, or one way in which a judge takes packages."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from export.files import Files
from export.package import Package


@dataclass(frozen=True, slots=True)
class Target:
    """One kind of package.

    name: as on the command line. title: the judge, in words. build: lays the package out.
    import_it: what to do with the file, one or two sentences. directory: it is written as a
    directory, not as a zip. compact: only the compact cases. max_bytes: the judge's limit on the
    zip; None: none is known.
    """

    name: str
    title: str
    build: Callable[[Package], Files]
    import_it: str
    directory: bool = False
    compact: bool = False
    max_bytes: int | None = None

    @property
    def file_name(self) -> str:
        """The name below build/export/."""
        return self.name if self.directory else f"{self.name}.zip"
