"""Joins JavaScript modules into one, in the order of their imports.

The sources keep to a few forms, so that no bundler is needed:

    import { a, b } from "./other.js";      (one line or several; no renaming, no default)
    export function …  export class …  export const …

All of their top-level names must differ, as they end up in one module. Comments that fill
whole lines are left out of it.
"""

from __future__ import annotations

import re
from pathlib import Path

from judge.kit.errors import KitError

_IMPORT = re.compile(r'^import \{([\w\s,$]*)\} from "(\.{1,2}/[\w./]+\.js)";\n', re.MULTILINE)
_EXPORT = re.compile(r"^export (?=(?:async )?(?:function|class|const)\b)", re.MULTILINE)
_TOP = re.compile(r"^(export )?(?:async )?(?:function\*?|class|const|let) ([\w$]+)", re.MULTILINE)
_COMMENT = re.compile(r"^[ ]*(?://.*\n|/\*\*(?:.|\n)*?\*/\n)", re.MULTILINE)
_OTHER_FORM = re.compile(r"^(?:import|export)\b.*", re.MULTILINE)


class ModuleError(KitError):
    """A module has a form that cannot be joined."""


def join(main: Path) -> str:
    """Return the text of `main` and of all that it imports, as one module. O(size).

    Raises ModuleError naming the file and what is wrong there; OSError if one is missing.
    """
    bodies: dict[Path, str] = {}
    exports: dict[Path, set[str]] = {}
    _visit(main.resolve(), main.resolve().parent, bodies, exports, ())
    _check_names(bodies, main.resolve().parent)
    return "\n".join(bodies.values())


def _visit(
    path: Path,
    root: Path,
    bodies: dict[Path, str],
    exports: dict[Path, set[str]],
    importers: tuple[Path, ...],
) -> None:
    """Add a module's body after those of its imports."""
    if path in bodies:
        return
    name = path.relative_to(root)
    if path in importers:
        raise ModuleError(f"{name}: imports itself, by way of {importers[-1].relative_to(root)}")
    text = path.read_text(encoding="utf-8")
    for names, source in _IMPORT.findall(text):
        imported = (path.parent / source).resolve()
        _visit(imported, root, bodies, exports, (*importers, path))
        wanted = {word.strip() for word in names.split(",")} - {""}
        missing = sorted(wanted - exports[imported])
        if missing:
            raise ModuleError(f"{name}: {source} does not export {', '.join(missing)}")
        unused = [word for word in wanted if len(re.findall(rf"\b{word}\b", text)) < 2]
        if unused:
            raise ModuleError(f"{name}: imports {', '.join(sorted(unused))} without use")
    exports[path] = {found for export, found in _TOP.findall(text) if export}
    body = _COMMENT.sub("", _EXPORT.sub("", _IMPORT.sub("", text)))
    if other := _OTHER_FORM.search(body):
        raise ModuleError(f"{name}: expected another form of import or export: {other[0]}")
    bodies[path] = f"// {name}\n{body.strip()}\n"


def _check_names(bodies: dict[Path, str], root: Path) -> None:
    """Check that no top-level name is taken twice."""
    owners: dict[str, Path] = {}
    for path, body in bodies.items():
        for _, name in _TOP.findall(body):
            if name in owners:
                raise ModuleError(
                    f"{path.relative_to(root)}: {name} is a top-level name "
                    f"of {owners[name].relative_to(root)}, too"
                )
            owners[name] = path
