"""Compiled submissions that several slow tests share: each is compiled once in all of them."""

from __future__ import annotations

import hashlib
import os
import shutil
from dataclasses import replace
from pathlib import Path

from judge.languages.submission import Program, Submission, compile_submission, names_of
from judge.languages.toolchain import toolchain
from judge.problem.declaration import Limits
from judge.sandbox.sandbox import Sandbox


class Compiled:
    """Compiles as the judge does, and keeps the program in a directory for the next time."""

    def __init__(self, directory: Path) -> None:
        self._directory = directory

    def compile(self, submission: Submission, limits: Limits, sandbox: Sandbox) -> Program:
        """Return the program, compiled now or before. Raises what `compile_submission` does."""
        key = hashlib.sha256(submission.language.name.encode() + submission.source).hexdigest()
        kept = self._directory / key
        if not kept.exists():
            program = compile_submission(submission, limits, sandbox)
            built = program.command.directory
            if built is not None and not any(path.is_symlink() for path in built.rglob("*")):
                mine = self._directory / f"{key}-{os.getpid()}"
                shutil.copytree(built, mine)
                try:
                    mine.rename(kept)
                except OSError:  # another process was faster
                    shutil.rmtree(mine)
            return program
        directory = sandbox.new_program_directory()
        shutil.copytree(kept, directory, dirs_exist_ok=True)
        tools = toolchain(submission.language)
        source_name, main = names_of(submission)
        inside = sandbox.inside(directory)
        command = tools.run_command(inside, source_name, main, limits.memory_mib)
        return Program(submission, replace(command, directory=directory))
