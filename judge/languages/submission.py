"""A submission: read from a file or from standard input, and compiled."""

from __future__ import annotations

import codecs
import re
from dataclasses import dataclass, replace
from pathlib import Path
from typing import IO

from judge.kit.errors import KitError
from judge.kit.text import printable_lines
from judge.languages.guess import guess
from judge.languages.java import java_names
from judge.languages.table import LANGUAGES, Language, by_suffix
from judge.languages.toolchain import toolchain
from judge.problem.declaration import Limits
from judge.sandbox.facts import RunLimits, Stop
from judge.sandbox.sandbox import Command, Sandbox, SandboxError

COMPILER_OUTPUT_MIB = 8
LONGEST_SOURCE_BYTES = 1 << 24  # far beyond any limit on the source's length


class SubmissionError(KitError):
    """The given file or text cannot be a submission."""


class CompileError(KitError):
    """The submission does not compile; the message is the compiler's, cut short."""


@dataclass(frozen=True, slots=True)
class Submission:
    """A source text in a known language. name: its path as given, or `standard input`."""

    name: str
    language: Language
    source: bytes


@dataclass(frozen=True, slots=True)
class Program:
    """A compiled submission, ready to be run any number of times."""

    submission: Submission
    command: Command

    def reason(self, stderr: bytes) -> str:
        """Return the line of standard error that says why the program crashed; it may be empty.

        In most languages that is the last line.
        """
        lines = printable_lines(stderr, lines=1000, width=120).splitlines()
        mark = self.submission.language.error_line
        telling = [line for line in lines if mark and re.search(mark, line)][:1] or lines[-1:]
        return "".join(telling)


def read_source(file: IO[bytes]) -> bytes:
    """Return at most the first LONGEST_SOURCE_BYTES of a file."""
    return file.read(LONGEST_SOURCE_BYTES)


def read_submission(path: Path, language: Language | None = None) -> Submission:
    """Read a file. Without `language`, its suffix or else its text decides the language.

    Raises SubmissionError.
    """
    if path.is_dir():
        raise SubmissionError(f"{path}: expected a source file, found a directory")
    try:
        with path.open("rb") as file:
            source = read_source(file)
    except FileNotFoundError:
        raise SubmissionError(f"{path}: no such file") from None
    except OSError as error:
        raise SubmissionError(f"{path}: cannot be read: {error.strerror}") from None
    known = language or by_suffix(path)
    if known is None and path.suffix:
        suffixes = " ".join(s for each in LANGUAGES for s in each.suffixes)
        raise SubmissionError(
            f"{path}: unknown language: expected a suffix among {suffixes}, "
            f"found {path.suffix!r} (or give --language)"
        )
    return from_source(source, str(path), known)


def from_source(source: bytes, name: str, language: Language | None = None) -> Submission:
    """Check a source text and guess its language if none is given. Raises SubmissionError.

    A byte order mark is removed: some editors write one, and some compilers refuse it.
    """
    source = source.removeprefix(codecs.BOM_UTF8)
    if not source.strip():
        raise SubmissionError(f"{name}: expected a source text, found nothing in it")
    if b"\0" in source:
        raise SubmissionError(
            f"{name}: expected a source text, found binary data (a zero byte at offset "
            f"{source.index(0)})"
        )
    found = language or guess(source.decode("utf-8", "replace"))
    if found is None:
        names = ", ".join(each.name for each in LANGUAGES)
        raise SubmissionError(
            f"{name}: the language cannot be guessed from the text; give --language with one of "
            f"{names}"
        )
    return Submission(name, found, source)


def compile_submission(submission: Submission, limits: Limits, sandbox: Sandbox) -> Program:
    """Compile once, in the sandbox. Raises CompileError, LanguageError or SandboxError."""
    if len(submission.source) > limits.code_kib << 10:
        raise CompileError(
            f"the source has {-(-len(submission.source) // 1024)} KiB, limit {limits.code_kib} KiB"
        )
    tools = toolchain(submission.language)
    directory = sandbox.new_program_directory()
    source_name, main = _names(submission)
    try:
        (directory / source_name).write_bytes(submission.source)
        tools.prepare(directory)
    except OSError as error:
        raise SandboxError(f"{directory}: no scratch space: {error.strerror}") from None
    run_limits = RunLimits(
        time_limit_s=limits.compilation_time_s,
        memory_mib=limits.compilation_memory_mib,
        output_mib=COMPILER_OUTPUT_MIB,
    )
    inside = sandbox.inside(directory)
    printed = sandbox.new_directory("compiler-") / "output"
    facts = sandbox.run(
        replace(tools.compile_command(inside, source_name), directory=directory),
        run_limits,
        stdin=None,
        stdout=printed,
        compiling=True,
    )
    said = printable_lines(facts.stderr or printed.read_bytes()[:8192])
    said = said.replace(f"{inside}/", "")
    if facts.stopped is not None:
        limit = {
            Stop.MEMORY: f"more than {run_limits.memory_mib} MiB of memory",
            Stop.OUTPUT: f"more than {COMPILER_OUTPUT_MIB} MiB of messages",
            Stop.PROCESSES: f"more than {run_limits.processes} processes",
        }.get(facts.stopped, f"more than {run_limits.time_limit_s:.0f} s")
        raise CompileError(f"the compiler was stopped: {limit}\n{said}".rstrip())
    if facts.exit_status != 0:
        sandbox.check_space()  # a full disk is not a compile error
        ended = f"signal {facts.signal}" if facts.signal else f"exit status {facts.exit_status}"
        raise CompileError(said or f"the compiler ended with {ended} and said nothing")
    command = tools.run_command(inside, source_name, main, limits.memory_mib)
    return Program(submission, replace(command, directory=directory))


def _names(submission: Submission) -> tuple[str, str]:
    """Return the name of the source file, and of the program or class to run."""
    language = submission.language
    stem = main = "submission"
    if language.name == "Java":
        stem, main = java_names(submission.source.decode("utf-8", "replace"))
    return stem + language.suffixes[0], main
