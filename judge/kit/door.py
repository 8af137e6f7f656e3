"""The door of every command: into the kit's own environment, whatever Python started it.

Any Python 3 can read this file, so that whoever comes with another interpreter, from any
directory, is led on or told what to do.
"""

import os
import sys
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ENVIRONMENT = ROOT / ".venv"
MINIMUM = (3, 11)
PACKAGES = ("msgspec", "rich", "drawsvg")  # that commands import
FAILED, INTERRUPTED = 2, 130


def start(module, script=None):  # type: (str, str | None) -> None
    """Run `main(arguments)` of a module in the kit's environment, and end with its status.

    script: the file that was started; None: the module's top folder, as by `python -m`.
    Where there is no such environment, an interpreter that has all packages will do.
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
        refuse(path.name, "the kit is not set up: run 'make setup' first")
    try:
        main = import_module(module).main
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)
    sys.exit(main(sys.argv[1:]))


def refuse(name, why):  # type: (str, str) -> None
    """End the process with one line."""
    if sys.stderr is not None:
        sys.stderr.write("{}: {}\n".format(name, why))  # noqa: UP032
    sys.exit(FAILED)
