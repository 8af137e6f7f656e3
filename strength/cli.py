"""The strength of the data: `python -m strength`, `python -m strength mutants`."""

from __future__ import annotations

import sys

from judge.kit.command import run
from strength import matrix_cli, mutation_cli


def main() -> int:
    """Run the command line; return its exit status: 0 strong, 1 not, 2 failed."""
    arguments = sys.argv[1:]

    def command() -> int:
        if arguments[:1] == ["mutants"]:
            return mutation_cli.main(arguments[1:])
        return matrix_cli.main(arguments)

    return run("strength", command, (*matrix_cli.ERRORS, *mutation_cli.ERRORS))


if __name__ == "__main__":
    sys.exit(main())
