"""A submission: read from a file or from standard input, and compiled."""

from __future__ import annotations

import codecs
import os
import stat
from dataclasses import dataclass, replace
from pathlib import Path
from typing import IO

from judge.kit.errors import KitError
from judge.kit.text import printable_name
from judge.languages.crash import compiler_lines, crash_reason, shown_stderr
from judge.languages.guess import guess
from judge.languages.java import java_names
from judge.languages.table import LANGUAGES, Language, by_suffix
from judge.languages.toolchain import toolchain
from judge.problem.declaration import Limits
from judge.sandbox.facts import RunLimits, Stop
from judge.sandbox.sandbox import Command, Sandbox, SandboxError

COMPILER_OUTPUT_MIB = 8
_KINDS = {stat.S_IFDIR: "a directory", stat.S_IFIFO: "a pipe", stat.S_IFSOCK: "a socket"}
_KINDS |= dict.fromkeys((stat.S_IFCHR, stat.S_IFBLK), "a device")
LONGEST_SOURCE_BYTES = 1 << 24  # far beyond any limit on the source's length


class SubmissionError(KitError):
    """The given file or text cannot be a submission."""


class CompileError(KitError):
    """The submission does not compile; the message is the compiler's, cut short."""


@dataclass(frozen=True, slots=True)
class Submission:
    """A source text in a known language. name: its path as given, or `standard input`.

    file: device and inode of the file that the source was read from, None without one.
    """

    name: str
    language: Language
    source: bytes
    file: tuple[int, int] | None = None

    @property
    def own_name(self) -> str:
        """The name of the user's file without its directory, printable; "" if there is none."""
        return printable_name(Path(self.name).name) if self.file else ""


@dataclass(frozen=True, slots=True)
class Program:
    """A compiled submission, ready to be run any number of times."""

    submission: Submission
    command: Command

    def reason(self, stderr: bytes) -> str:
        """Return one line that says where and why the program crashed; it may be empty."""
        if not stderr:
            return ""
        return crash_reason(self.submission.language, names_of(self.submission)[0], stderr)

    def shown(self, stderr: bytes) -> str:
        """Return standard error as printable lines that name the user's file; it may be empty."""
        if not stderr:
            return ""
        source = names_of(self.submission)[0]
        return shown_stderr(stderr, source, self.submission.own_name or source)


def read_source(file: IO[bytes]) -> bytes:
    """Return at most the first LONGEST_SOURCE_BYTES of a file."""
    return file.read(LONGEST_SOURCE_BYTES)


def read_submission(path: Path, language: Language | None = None) -> Submission:
    """Read a file; its suffix tells the language, else its text. Raises SubmissionError."""
    try:
        source, file = _read_once(path)
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
    return replace(from_source(source, str(path), known), file=file)


def _read_once(path: Path) -> tuple[bytes, tuple[int, int]]:
    """Return the content of a regular file, and its device and inode. Raises OSError.

    What is judged, vouched for and compiled is what this one descriptor shows, whatever becomes
    of the path. A link is followed only to a file of its own owner: in a directory that somebody
    else filled, it could lead to what only this user may read.
    """
    descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC | os.O_NOCTTY)
    try:
        found, named = os.fstat(descriptor), path.lstat()
        if not stat.S_ISREG(found.st_mode):
            kind = _KINDS.get(stat.S_IFMT(found.st_mode), "something else")
            raise SubmissionError(f"{path}: expected a source file, found {kind}")
        if stat.S_ISLNK(named.st_mode) and found.st_uid != named.st_uid:
            raise SubmissionError(
                f"{path}: expected a link to a file of its owner, found another user's"
            )
        with os.fdopen(descriptor, "rb", closefd=False) as file:
            return read_source(file), (found.st_dev, found.st_ino)
    finally:
        os.close(descriptor)


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
    source_name, main = names_of(submission)
    try:
        (directory / source_name).write_bytes(submission.source)
        tools.prepare(directory)
    except OSError as error:
        raise SandboxError(f"{directory}: no scratch space: {error.strerror}") from None
    run_limits = RunLimits(
        time_limit_s=limits.compilation_time_s,
        memory_mib=limits.compilation_memory_mib,
        output_mib=COMPILER_OUTPUT_MIB,
        elapsed_s=limits.compilation_time_s,
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
    said = compiler_lines(facts.stderr or printed.read_bytes()[:8192])
    said = said.replace(f"{inside}/", "").replace(source_name, submission.own_name or source_name)
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


def names_of(submission: Submission) -> tuple[str, str]:
    """Return the name of the source file, and of the program or class to run."""
    language = submission.language
    stem = main = "submission"
    if language.name == "Java":
        stem, main = java_names(submission.source.decode("utf-8", "replace"))
    return stem + language.suffixes[0], main
