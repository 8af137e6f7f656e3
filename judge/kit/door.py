"""The entry of every command: it restarts itself in the kit's environment.

This file works with any Python 3 and from any directory. If the restart is impossible, it
prints one line that says what to do.
"""

import os
import sys
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ENVIRONMENT = ROOT / ".venv"
MINIMUM = (3, 11)
PACKAGES = ("msgspec", "rich", "drawsvg", "jinja2")  # imported by commands
FAILED, INTERRUPTED = 2, 130


def start(module, script=None):  # type: (str, str | None) -> None
    """Run `main(arguments)` of a module in the kit's environment, and exit with its status.

    script: the file or folder to start again; None: the top folder of the module.
    Without that environment, any interpreter that has all packages is accepted.
    """
    path = ROOT / (script or module.partition(".")[0])
    python = ENVIRONMENT / "bin" / "python"
    if Path(sys.prefix).resolve() != ENVIRONMENT.resolve():
        if os.access(str(python), os.X_OK):
            os.execv(str(python), [str(python), str(path)] + sys.argv[1:])  # noqa: RUF005
        if python.exists():
            refuse(path.name, "{} cannot be executed by this user".format(python))  # noqa: UP032
        if os.path.lexists(str(python)):
            refuse(path.name, "the Python of .venv is gone: run 'make setup'")
    if sys.version_info < MINIMUM or not all(map(find_spec, PACKAGES)):
        refuse(path.name, f"the kit is not set up: run 'make -C {ROOT} setup' first")
    try:
        main = import_module(module).main
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)
    sys.exit(main(sys.argv[1:]))


def refuse(name, why):  # type: (str, str) -> None
    """Print one line and exit with status 2."""
    if sys.stderr is not None:
        sys.stderr.write("{}: {}\n".format(name, why))  # noqa: UP032
    sys.exit(FAILED)
