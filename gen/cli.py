"""The command line of the generators: one command line, a module for each command."""

from __future__ import annotations

from collections.abc import Sequence

from gen.build import BuildError
from gen.commands import build, case, check, clean, listing, make, remove
from gen.commands.common import NOT_OK
from gen.validator import UsageError
from judge.kit.command import Parser, complain, run

COMMANDS = (listing, make, build, check, case, remove, clean)


def main(arguments: Sequence[str]) -> int:
    """Run one command; return the exit status: 0 ok, 1 not ok, 2 usage error."""

    def command() -> int:
        options = _parser().parse_args(arguments)
        try:
            status: int = options.command(options)
        except BuildError as error:
            complain(f"gen: {error}")
            return NOT_OK
        return status

    return run(
        "gen", command, (UsageError,), "interrupted; what was built stays, nothing is half-written"
    )


def _parser() -> Parser:
    parser = Parser(prog="python -m gen", description="Make and check test data.")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    for command in COMMANDS:
        command.add(commands)
    return parser
